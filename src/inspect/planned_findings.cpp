#include "inspect/planned_findings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/units.hpp"
#include "plan/part_fit.hpp"

namespace rva {
namespace {

/// A pixel of the final depth image, and the depth there where it is known.
struct SeenPoint {
  Eigen::Vector2d pixel{0, 0};
  std::optional<Eigen::Vector3d> position_m{};  ///< in the final camera's frame
};

/// Where the pixels of the baseline's picture are in the final view.
class FinalView {
 public:
  FinalView(const Detection& detection, const Capture& initial, const CaptureInfo& final)
      : final_from_initial_(detection.findings.final_from_initial),
        initial_(initial.info().depth),
        final_(final.depth),
        depth_(initial.depth(0)),
        unit_m_(initial.info().depth_unit_m) {}

  /// @param depth_m along z of the baseline's camera, if the plan states it
  [[nodiscard]] SeenPoint at(const Eigen::Vector2d& pixel, std::optional<double> depth_m) const {
    if (!depth_m) depth_m = measured_m(pixel);
    if (!depth_m) return {pixel, std::nullopt};
    const Eigen::Vector3d point = final_from_initial_ * initial_.deproject(pixel, *depth_m);
    if (point.z() <= 0.0) return {pixel, std::nullopt};
    return {final_.project(point), point};
  }

  /// A box about a point, as large as a length in space, within the image and not empty.
  [[nodiscard]] Box box_about(const SeenPoint& seen, double length_mm) const {
    constexpr double least_px = 12.0;
    const double depth_m = seen.position_m ? seen.position_m->z() : 0.0;
    const double length_px = depth_m > 0.0 ? final_.fx * m_per_mm * length_mm / depth_m : least_px;
    const double half_px = 0.5 * std::max(least_px, length_px);
    return box_between(seen.pixel - Eigen::Vector2d::Constant(half_px),
                       seen.pixel + Eigen::Vector2d::Constant(half_px));
  }

  [[nodiscard]] Box box_between(const Eigen::Vector2d& least, const Eigen::Vector2d& greatest) const {
    const auto inside = [](double value, int size) {
      return static_cast<int>(std::lround(std::clamp(value, 0.0, size - 1.0)));
    };
    const int left = inside(least.x(), final_.width);
    const int top = inside(least.y(), final_.height);
    return {left, top, inside(greatest.x(), final_.width) - left + 1,
            inside(greatest.y(), final_.height) - top + 1};
  }

 private:
  [[nodiscard]] std::optional<double> measured_m(const Eigen::Vector2d& pixel) const {
    if (!initial_.contains(pixel)) return std::nullopt;
    const std::uint16_t depth =
        depth_(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    if (depth == no_depth) return std::nullopt;
    return unit_m_ * depth;
  }

  Transform final_from_initial_;
  Intrinsics initial_;
  Intrinsics final_;
  DepthImage depth_;
  double unit_m_;
};

ReviewedFinding missing_part(const PictureItem& item, const AbsentPart& part, const FinalView& view) {
  const PlannedItem& planned = *item.item;
  ReviewedFinding missing;
  missing.planned = PlannedState::missing;
  missing.planned_item = planned.name;
  missing.finding.kind = planned.kind;
  missing.finding.evidence = {false, false};
  if (part.pixel) {
    const SeenPoint seen = view.at(*part.pixel, item.depth_m);
    const double length_mm =
        std::max(2.0 * planned.tolerance_mm, planned.size_mm ? planned.size_mm->high : 0.0);
    missing.finding.box = view.box_about(seen, length_mm);
    missing.finding.position_m = seen.position_m;
  } else {
    Eigen::Vector2d least = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d greatest = -least;
    for (const Eigen::Vector2d& corner : item.areas.front()) {
      const SeenPoint seen = view.at(corner, item.depth_m);
      least = least.cwiseMin(seen.pixel);
      greatest = greatest.cwiseMax(seen.pixel);
    }
    missing.finding.box = view.box_between(least, greatest);
  }
  const Box& box = missing.finding.box;
  missing.finding.centroid = {box.x + 0.5 * (box.width - 1), box.y + 0.5 * (box.height - 1)};
  return missing;
}

}  // namespace

void add_planned(std::vector<ReviewedFinding>& findings, const PlanMatch& match, const Plan& plan,
                 const Detection& detection, const Capture& initial, const CaptureInfo& final) {
  for (ReviewedFinding& reviewed : findings) {
    const auto state = std::ranges::find(match.findings, reviewed.finding.id, &PlannedFinding::id);
    if (state == match.findings.end()) continue;
    reviewed.planned = state->state;
    reviewed.planned_item = state->item.value_or("");
  }
  const std::vector<PictureItem> items = in_picture(plan, initial.info().depth);
  const FinalView view(detection, initial, final);
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const AbsentPart& part : match.groups.at(i).missing)
      findings.push_back(missing_part(items[i], part, view));
  }
}

std::vector<PlannedWork> planned_work(const PlanMatch& match) {
  std::vector<PlannedWork> work;
  for (const PlannedGroup& group : match.groups)
    work.push_back({group.name, group.kind, group.planned, group.found,
                    static_cast<int>(group.missing.size()), static_cast<int>(group.not_inspected.size())});
  return work;
}

}  // namespace rva
