#include "cli/plan_printing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "cli/printing.hpp"

namespace rva::cli {
namespace {

std::string described(const LoosePiece& piece, const std::vector<Finding>& findings) {
  const Finding& finding = *std::ranges::find(findings, piece.finding, &Finding::id);
  std::string text = fmt::format("finding {}, {}, box {} {} {} {} px", finding.id, name_of(finding.kind),
                                 piece.box.x, piece.box.y, piece.box.width, piece.box.height);
  if (piece.height_mm) text += fmt::format(", height {:.1f} mm", *piece.height_mm);
  if (finding.position_m) text += fmt::format(", distance {:.2f} m", finding.position_m->z());
  return text;
}

// Parts whose places are not known are counted, others named one by one.
void print_absent(std::string_view what, const std::string& name, const std::vector<AbsentPart>& parts) {
  if (parts.empty()) return;
  if (!parts.front().place) {
    print("{}: {} of {}\n", what, parts.size(), name);
    return;
  }
  for (const AbsentPart& part : parts)
    print("{}: {}, place {}, at pixel {:.0f} {:.0f} of the baseline\n", what, name, *part.place,
          part.pixel->x(), part.pixel->y());
}

}  // namespace

void print_plan(const PlanMatch& match, const std::vector<Finding>& findings) {
  for (const LoosePiece& piece : match.unplanned) print("unplanned: {}\n", described(piece, findings));
  for (const PlannedGroup& group : match.groups)
    print("planned: {} of {} {}\n", group.found, group.planned, group.name);
  for (const PlannedGroup& group : match.groups) print_absent("missing", group.name, group.missing);
  for (const PlannedGroup& group : match.groups)
    print_absent("not inspected", group.name, group.not_inspected);
  for (const LoosePiece& piece : match.surplus)
    print("surplus: {}, beyond the planned {}\n", described(piece, findings), *piece.item);
}

}  // namespace rva::cli
