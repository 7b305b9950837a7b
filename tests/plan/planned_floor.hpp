// A floor a metre in front of the camera, with changes on it, as a detection reports them.
#pragma once

#include <string>
#include <utility>

#include "detect/findings/detection.hpp"
#include "plan/plan_match.hpp"

namespace rva::test {

inline constexpr int floor_width = 200;
inline constexpr int floor_height = 120;

/// At 1 m, one pixel is 2 mm.
inline Intrinsics floor_camera() {
  Intrinsics camera;
  camera.width = floor_width;
  camera.height = floor_height;
  camera.fx = camera.fy = 500.0;
  camera.cx = 99.5;
  camera.cy = 59.5;
  return camera;
}

/// A detection that found nothing, and would have found 4 mm everywhere.
inline Detection clean_floor() {
  Detection detection;
  detection.initial_m = detection.final_m = Image<float>(floor_width, floor_height, 1.0F);
  detection.changed = Mask(floor_width, floor_height);
  detection.level_of_detection = LevelOfDetection{Image<float>(floor_width, floor_height, 4.0F), {}};
  return detection;
}

/// Adds the pixels of a box to a finding, and raises the floor there.
inline void raise(const Box& box, double height_mm, Finding& finding, Detection& detection) {
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      detection.final_m(u, v) = 1.0F - static_cast<float>(1e-3 * height_mm);
      detection.changed(u, v) = mask_set;
      finding.pixels.push_back(static_cast<std::uint32_t>(v * floor_width + u));
    }
  }
}

/// Adds a finding of one box; its kind follows from the sign of its height.
inline void add_finding(const Box& box, double height_mm, Detection& detection) {
  Finding finding;
  finding.id = static_cast<int>(detection.findings.findings.size()) + 1;
  finding.kind = height_mm > 0.0 ? ChangeKind::added : ChangeKind::removed;
  finding.box = box;
  raise(box, height_mm, finding, detection);
  detection.findings.findings.push_back(std::move(finding));
}

/// The findings compared with the text of a plan in pixels, without its head.
inline PlanMatch matched(const std::string& parts, const Detection& detection) {
  const Plan plan = parse_plan("format: rva-plan\nversion: 1\nparts:\n" + parts, "plan.yaml");
  PlanOptions options;
  options.height_error_mm = 3.0;
  return match_plan(plan, detection, {floor_camera(), floor_camera()}, options);
}

}  // namespace rva::test
