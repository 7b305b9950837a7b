#include "views/baseline_poses.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "geometry/rigid_motion.hpp"
#include "infrared/infrared_alignment.hpp"
#include "infrared/infrared_check.hpp"
#include "views/view_motion.hpp"

namespace rva {
namespace {

// With fewer captures, dots cover most of the image of the others. Comparisons have the same limit.
constexpr std::size_t least_captures = 4;
// In a bay with little texture, a round makes up for a fifth of a turn or less, so that the 8 rounds of a
// comparison do not converge (docs/robot.md has measurements).
constexpr int many_rounds = 40;

ReferenceSurface surface_of(const Capture& capture) {
  const DepthView view = depth_view(capture);
  return reference_surface(view.camera, view.disparity_px, view.stereo);
}

// Where the robot states that the captures were taken, in the frame of the first.
Transform view_from_first(const Captures& captures, std::size_t capture) {
  const auto world_from = [&](std::size_t k) {
    return captures[k]->info().pose.value_or(Pose{}).world_from_camera.value_or(Transform::Identity());
  };
  return world_from(capture).inverse() * world_from(0);
}

std::optional<double> turn_by_depth_deg(const DepthView& before, const Capture& returned) {
  const ViewMotion motion = view_motion(before, depth_view(returned));
  if (motion.tiles == 0.0) return std::nullopt;
  return degrees(motion.displacement_px / before.camera.fx);
}

}  // namespace

/// The baseline's infrared images, laid upon each other.
class BaselinePoses::Infrared {
 public:
  explicit Infrared(const Captures& captures) : surface_(surface_of(*captures.front())) {
    if (surface_.inverse_depth_per_m.empty()) return;
    level_ = exposed_level(grey_of(*captures.front()), Light::projector);
    for (std::size_t k = 0; k < captures.size(); ++k)
      views_.push_back(view_of(*captures[k], view_from_first(captures, k)));
    align_side(surface_, views_);
  }

  [[nodiscard]] std::optional<double> turn_deg(std::size_t capture, const Capture& returned) {
    if (views_.empty() || !returned.has_infrared(Imager::left, Light::projector)) return std::nullopt;
    const Laid& baseline = laid_upon_others(capture);
    const Transform& from = baseline.own.front().view_from_reference;
    std::vector<InfraredView> now{view_of(returned, from)};
    align_to(baseline.others, surface_, now, many_rounds);
    const Transform turn = now.front().view_from_reference * from.inverse();
    return angle_deg_of(turn);
  }

 private:
  /// One capture's view, laid upon the image of all others.
  struct Laid {
    DotFreeImage others;
    std::vector<InfraredView> own;
  };

  const Laid& laid_upon_others(std::size_t capture) {
    const auto known = laid_.find(capture);
    if (known != laid_.end()) return known->second;
    std::vector<InfraredView> others = views_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(capture));
    Laid laid{fuse(surface_, others), {views_[capture]}};
    align_to(laid.others, surface_, laid.own, many_rounds);
    return laid_.emplace(capture, std::move(laid)).first->second;
  }

  static Image<float> grey_of(const Capture& capture) {
    return capture.infrared_mean(Imager::left, Light::projector).value();
  }
  [[nodiscard]] InfraredView view_of(const Capture& capture, const Transform& view_from_first) const {
    const Image<float> grey = grey_of(capture);
    return {grey, view_from_first, Light::projector, scale_to_level(level_, grey, Light::projector)};
  }

  ReferenceSurface surface_;
  float level_ = 0.0F;  // of grey, that all images are brought to
  std::vector<InfraredView> views_;
  std::map<std::size_t, Laid> laid_;  // by capture, as far as they were asked for
};

BaselinePoses::BaselinePoses(const Captures& captures) : captures_(captures), depth_(captures.size()) {
  const auto has_infrared = [](const auto& capture) {
    return capture->has_infrared(Imager::left, Light::projector);
  };
  const bool bends_rays = captures.front()->info().depth.distortion != Distortion::none;
  if (captures.size() >= least_captures && std::ranges::all_of(captures, has_infrared) && !bends_rays)
    infrared_ = std::make_unique<Infrared>(captures);
}

BaselinePoses::~BaselinePoses() = default;

const DepthView& BaselinePoses::depth_of(std::size_t capture) {
  std::optional<DepthView>& depth = depth_.at(capture);
  if (!depth) depth = depth_view(*captures_[capture]);
  return *depth;
}

std::optional<double> BaselinePoses::turn_deg(std::size_t capture, const Capture& returned) {
  if (returned.info().depth.distortion != Distortion::none) return std::nullopt;
  const std::optional<double> by_depth = turn_by_depth_deg(depth_of(capture), returned);
  const std::optional<double> by_infrared =
      infrared_ ? infrared_->turn_deg(capture, returned) : std::optional<double>();
  if (!by_depth || !by_infrared) return by_depth ? by_depth : by_infrared;
  return std::max(*by_depth, *by_infrared);
}

}  // namespace rva
