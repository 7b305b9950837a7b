#include "map/pose_refinement.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>

#include "core/interrupt.hpp"
#include "core/units.hpp"
#include "map/overlapping_views.hpp"

namespace rva {
namespace {

// The schedule goes from a reach for the error of worn servos down to four deviations of a matcher's fixed
// pattern.
constexpr std::array<PosesDescent, 9> descent{{{.step_px = 8, .every = 4, .reach_px = 6.0},
                                               {.step_px = 8, .every = 4, .reach_px = 4.0},
                                               {.step_px = 8, .every = 4, .reach_px = 3.0},
                                               {.step_px = 8, .every = 4, .reach_px = 2.0},
                                               {.step_px = 4, .every = 4, .reach_px = 1.5},
                                               {.step_px = 4, .every = 2, .reach_px = 1.2},
                                               {.step_px = 4, .every = 2, .reach_px = 0.9},
                                               {.step_px = 4, .every = 2, .reach_px = 0.7},
                                               {.step_px = 4, .every = 2, .reach_px = 0.6}}};

// The information (inverse covariance) of a camera's motion away from its pose by the joints.
TwistMatrix prior_information(const PanTiltChain& chain, const PanTilt& joints,
                              const RefinementOptions& options) {
  const auto [pan, tilt] = joint_twists(chain, joints);
  const double servo_rad = rad_per_deg * options.servo_error_deg;
  const double turn_rad = rad_per_deg * options.turn_error_deg;
  const double place_m = m_per_mm * options.place_error_mm;
  TwistMatrix covariance = servo_rad * servo_rad * (pan * pan.transpose() + tilt * tilt.transpose());
  covariance.diagonal().head<3>().array() += turn_rad * turn_rad;
  covariance.diagonal().tail<3>().array() += place_m * place_m;
  return covariance.inverse();
}

class Refinement {
 public:
  Refinement(std::span<const MapView> views, const PanTiltChain& chain, const RefinementOptions& options)
      : by_surfaces_(views) {
    for (const MapView& view : views) {
      by_joints_.push_back(foot_from_camera(chain, view.joints));
      prior_.push_back(prior_information(chain, view.joints, options));
    }
    poses_ = by_joints_;
  }

  std::vector<RefinedPose> run() {
    pairs_ = by_surfaces_.pairs(poses_);
    for (const PosesDescent& how : descent) {
      throw_if_interrupted();
      step(by_surfaces_.equations(poses_, pairs_, how));
    }
    return results(by_surfaces_.equations(poses_, pairs_, descent.back()));
  }

 private:
  void step(PoseEquations sum) {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(6 * i);
      sum.information.block<6, 6>(at, at) += prior_[i];
      sum.gradient.segment<6>(at) += prior_[i] * log_of(by_joints_[i].inverse() * poses_[i]);
    }
    // Dense: from one foot, most pairs of views overlap, and the factor of a sparse matrix would be nearly
    // full as well. In place, since the matrix of 1000 views takes 288 MB.
    const Eigen::LDLT<Eigen::Ref<Eigen::MatrixXd>> factor(sum.information);
    const Eigen::VectorXd motions = -factor.solve(sum.gradient);
    for (std::size_t i = 0; i < poses_.size(); ++i)
      poses_[i] = poses_[i] * exp_of(motions.segment<6>(static_cast<Eigen::Index>(6 * i)));
  }

  [[nodiscard]] std::vector<RefinedPose> results(const PoseEquations& sum) const {
    std::vector<RefinedPose> results;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const Twist moved = log_of(by_joints_[i].inverse() * poses_[i]);
      const ViewResiduals& residuals = sum.views[i];
      RefinedPose pose{.foot_from_camera = poses_[i],
                       .moved_mm = moved.tail<3>().norm() / m_per_mm,
                       .turned_deg = moved.head<3>().norm() / rad_per_deg,
                       .neighbours = residuals.neighbours,
                       .agreeing = residuals.share(),
                       .residual_px = residuals.residual_px(),
                       .doubt = {}};
      pose.doubt = doubt_of(pose);
      if (!pose.doubt.empty()) pose.foot_from_camera = by_joints_[i];
      results.push_back(pose);
    }
    return results;
  }

  static std::string doubt_of(const RefinedPose& pose) {
    constexpr double least_agreeing = 0.5;
    if (pose.neighbours == 0) return "shares no surface with another view";
    if (pose.agreeing < least_agreeing)
      return fmt::format("only {:.0f} % of its overlap with other views lies on the same surfaces",
                         100.0 * pose.agreeing);
    return {};
  }

  OverlappingViews by_surfaces_;
  std::vector<Transform> by_joints_;
  std::vector<TwistMatrix> prior_;
  std::vector<Transform> poses_;
  std::vector<ViewNumbers> pairs_;
};

}  // namespace

std::vector<RefinedPose> refine_poses(std::span<const MapView> views, const PanTiltChain& chain,
                                      const RefinementOptions& options) {
  check_options(options);
  return Refinement(views, chain, options).run();
}

}  // namespace rva
