// Compares two captures of one scene, before and after the work, with the method that suits them, and prints
// a line for each finding. Run it as `build/examples/detect data/bin-tools/initial data/bin-tools/final`.
#include "detect/detect.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "capture/capture.hpp"
#include "core/error.hpp"

namespace {

// A method leaves empty what it cannot measure.
std::string or_dash(std::optional<double> value) { return value ? fmt::format("{:.3g}", *value) : "-"; }

void print(const rva::Finding& finding) {
  fmt::print("{:3} {:10}", finding.id, rva::name_of(finding.kind));
  if (finding.position_m)
    fmt::print("  at ({:.3f}, {:.3f}, {:.3f}) m", finding.position_m->x(), finding.position_m->y(),
               finding.position_m->z());
  if (finding.size_mm)
    fmt::print("  size {:.0f} x {:.0f} mm", finding.size_mm->at(0), finding.size_mm->at(1));
  fmt::print("  height {} mm  p-value {}\n", or_dash(finding.height_mm), or_dash(finding.p_value));
}

void detect(const char* initial_path, const char* final_path) {
  // Each side may have several captures, taken a few servo steps apart; here it has one.
  rva::Captures initial;
  rva::Captures final;
  initial.push_back(rva::open_capture(initial_path));
  final.push_back(rva::open_capture(final_path));

  const rva::DetectOptions options;  // the method is DetectionMethod::automatic
  const rva::SidesDetection result = rva::detect(initial, final, options, {});
  const rva::Findings& findings = result.detection.findings;
  fmt::print("{} finding(s) by method {}\n", findings.findings.size(), findings.method);
  for (const rva::Finding& finding : findings.findings) print(finding);
  fmt::print("coverage: compared {:.1f} %, not seen before {:.1f} %, not measured {:.1f} %\n",
             100.0 * findings.coverage.compared, 100.0 * findings.coverage.unseen,
             100.0 * findings.coverage.invalid);
  for (const std::string& warning : result.detection.warnings)
    fmt::print(stderr, "detect: warning: {}\n", warning);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: detect INITIAL FINAL\n");
    return 2;
  }
  try {
    detect(argv[1], argv[2]);
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "detect: {}\n", error.what());
    return 1;
  }
}
