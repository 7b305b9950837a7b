// How a report looks, on a screen and on paper.
#pragma once

#include <string_view>

namespace rva {

/// CSS. Findings are not broken over pages; paper is A4 or Letter, whichever the printer has.
inline constexpr std::string_view report_style = R"(
  @page { margin: 11mm 13mm; }
  :root { color-scheme: light; }
  body { font: 9pt/1.25 "Helvetica Neue", Arial, "Liberation Sans", sans-serif; color: #111; background: #fff; max-width: 182mm; margin: 6mm auto; padding: 0 4mm; }
  @media print { body { margin: 0; padding: 0; max-width: none; } }
  h1 { font-size: 15pt; margin: 0 0 1mm; }
  h2 { font-size: 11pt; margin: 3mm 0 1mm; border-bottom: 0.3mm solid #999; break-after: avoid; }
  h3 { font-size: 10pt; margin: 0 0 1mm; break-after: avoid; }
  p { margin: 0.5mm 0; }
  dl { display: grid; grid-template-columns: max-content 1fr max-content 2fr; gap: 0.5mm 4mm; margin: 0; }
  dt { color: #555; }
  dd { margin: 0; font-weight: 600; }
  dd, td, p, h3 { overflow-wrap: anywhere; }
  .typed { white-space: pre-line; }
  .verdict { margin: 2mm 0; padding: 2mm 4mm; border: 0.5mm solid; border-left-width: 3mm; break-inside: avoid; }
  .verdict .sentence { font-size: 13pt; font-weight: 700; }
  blockquote { margin: 1mm 0 0; padding-left: 3mm; border-left: 0.6mm solid #bbb; font-style: italic; overflow-wrap: anywhere; }
  .clear { border-color: #1b7a34; }
  .bad { border-color: #b3121d; }
  .warn { border-color: #a86400; }
  .verdict.open { border-color: #555; }
  table { border-collapse: collapse; width: 100%; margin: 1mm 0; font-size: 8pt; }
  th, td { text-align: left; vertical-align: top; padding: 0.3mm 3mm 0.3mm 0; border-bottom: 0.2mm solid #ccc; }
  th { font-weight: 600; color: #444; }
  tr { break-inside: avoid; }
  .coverage th:nth-child(-n+5), .coverage td:nth-child(-n+5) { white-space: nowrap; width: 1%; }
  .events td:first-child { white-space: nowrap; width: 1%; }
  .events td:nth-child(2) { width: 25%; }
  .settings table { font-size: 7.5pt; }
  .checksums code { font-size: 7pt; }
  code { font-family: "DejaVu Sans Mono", monospace; font-size: 7pt; overflow-wrap: anywhere; }
  .legend, .warnings, .settings, footer { font-size: 7.5pt; color: #444; }
  .warnings { margin: 1mm 0; padding-left: 5mm; }
  figure { margin: 0; break-inside: avoid; }
  figcaption { font-size: 8pt; color: #444; }
  img { width: 100%; display: block; }
  .pictures { display: grid; gap: 3mm; margin-top: 1mm; }
  .two { grid-template-columns: repeat(2, 1fr); }
  .three { grid-template-columns: repeat(3, 1fr); }
  .finding { break-inside: avoid; margin: 2mm 0; padding: 2mm 0 2mm 3mm; border-left: 0.8mm solid #bbb; }
  .crops { display: grid; grid-template-columns: repeat(4, 1fr); gap: 2mm; margin-top: 1mm; }
  .missing { color: #b3121d; }
  .decision.open { color: #b3121d; font-weight: 600; }
  footer { margin-top: 2mm; border-top: 0.3mm solid #999; padding-top: 1mm; }
)";

}  // namespace rva
