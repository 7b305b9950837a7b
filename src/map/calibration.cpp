#include "map/calibration.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/units.hpp"

namespace rva {
namespace {

constexpr Eigen::Index geometry_numbers = 8;
constexpr Eigen::Index joint_numbers = 2;

/// Differences from the given geometry, in metres and radians.
using GeometryChange = Eigen::Matrix<double, geometry_numbers, 1>;

struct NumberKind {
  std::string_view name;
  bool is_turn;
};
constexpr std::array<NumberKind, geometry_numbers> kinds{{{"tilt axis, forward of the pan axis", false},
                                                          {"tilt axis, leaning to the right", true},
                                                          {"camera, right", false},
                                                          {"camera, forward", false},
                                                          {"camera, up", false},
                                                          {"camera, turned about right", true},
                                                          {"camera, turned about forward", true},
                                                          {"camera, turned about up", true}}};

PanTiltChain changed(PanTiltChain chain, const GeometryChange& change) {
  chain.bracket.at_m.y() += change[0];
  chain.bracket.axis = Eigen::AngleAxisd(change[1], Eigen::Vector3d::UnitY()) * chain.bracket.axis;
  const Eigen::Vector3d turn = change.tail<3>();
  chain.bracket_from_camera.translation() += change.segment<3>(2);
  chain.bracket_from_camera.linear() =
      (exp_of((Twist() << turn, Eigen::Vector3d::Zero()).finished()) * chain.bracket_from_camera).linear();
  return chain;
}

// The schedule begins with a reach for a bracket measured by hand, and ends as the one for poses.
constexpr std::array<PosesDescent, 18> descent{{{.step_px = 8, .every = 4, .reach_px = 24.0},
                                                {.step_px = 8, .every = 4, .reach_px = 20.0},
                                                {.step_px = 8, .every = 4, .reach_px = 16.0},
                                                {.step_px = 8, .every = 4, .reach_px = 12.0},
                                                {.step_px = 8, .every = 4, .reach_px = 10.0},
                                                {.step_px = 8, .every = 4, .reach_px = 8.0},
                                                {.step_px = 8, .every = 4, .reach_px = 6.0},
                                                {.step_px = 8, .every = 4, .reach_px = 4.0},
                                                {.step_px = 8, .every = 4, .reach_px = 3.0},
                                                {.step_px = 8, .every = 4, .reach_px = 2.0},
                                                {.step_px = 8, .every = 4, .reach_px = 2.0},
                                                {.step_px = 4, .every = 4, .reach_px = 1.5},
                                                {.step_px = 4, .every = 2, .reach_px = 1.2},
                                                {.step_px = 4, .every = 2, .reach_px = 0.9},
                                                {.step_px = 4, .every = 2, .reach_px = 0.7},
                                                {.step_px = 4, .every = 2, .reach_px = 0.6},
                                                {.step_px = 4, .every = 2, .reach_px = 0.6},
                                                {.step_px = 4, .every = 2, .reach_px = 0.6}}};

class Estimation {
 public:
  Estimation(std::span<const MapView> views, const PanTiltChain& given, const CalibrationOptions& options)
      : by_surfaces_(views), given_(given) {
    for (const MapView& view : views) {
      joints_.push_back(view.joints);
      names_.push_back(view.name);
    }
    const auto unknowns = geometry_numbers + joint_numbers * static_cast<Eigen::Index>(views.size());
    unknowns_ = Eigen::VectorXd::Zero(unknowns);
    prior_deviations_ = Eigen::VectorXd::Constant(unknowns, rad_per_deg * options.servo_error_deg);
    for (std::size_t i = 0; i < kinds.size(); ++i)
      prior_deviations_[static_cast<Eigen::Index>(i)] =
          kinds.at(i).is_turn ? rad_per_deg * options.turn_error_deg : m_per_mm * options.place_error_mm;
  }

  Calibration run() {
    const std::vector<Transform> given_poses = poses(unknowns_);
    const PoseEquations before =
        by_surfaces_.equations(given_poses, by_surfaces_.pairs(given_poses), descent.back());
    std::vector<ViewNumbers> pairs;
    for (std::size_t i = 0; i < descent.size(); ++i) {
      throw_if_interrupted();
      if (i % 6 == 0) pairs = by_surfaces_.pairs(poses(unknowns_));
      step(by_surfaces_.equations(poses(unknowns_), pairs, descent.at(i)));
    }
    return result(before, by_surfaces_.equations(poses(unknowns_), pairs, descent.back()));
  }

 private:
  [[nodiscard]] PanTiltChain chain(const Eigen::VectorXd& unknowns) const {
    return changed(given_, unknowns.head<geometry_numbers>());
  }

  [[nodiscard]] PanTilt joint_error(const Eigen::VectorXd& unknowns, std::size_t view) const {
    const auto at = geometry_numbers + joint_numbers * static_cast<Eigen::Index>(view);
    return {unknowns[at] / rad_per_deg, unknowns[at + 1] / rad_per_deg};
  }

  [[nodiscard]] Transform pose(const Eigen::VectorXd& unknowns, std::size_t view) const {
    const PanTilt error = joint_error(unknowns, view);
    return foot_from_camera(chain(unknowns),
                            {joints_[view].pan_deg + error.pan_deg, joints_[view].tilt_deg + error.tilt_deg});
  }

  [[nodiscard]] std::vector<Transform> poses(const Eigen::VectorXd& unknowns) const {
    std::vector<Transform> result;
    for (std::size_t i = 0; i < joints_.size(); ++i) result.push_back(pose(unknowns, i));
    return result;
  }

  // The Jacobian of the cameras' motions with respect to the unknowns, by finite differences.
  [[nodiscard]] Eigen::MatrixXd motions_by_unknowns() const {
    constexpr double difference = 1e-5;
    Eigen::MatrixXd motions =
        Eigen::MatrixXd::Zero(6 * static_cast<Eigen::Index>(joints_.size()), unknowns_.size());
    for (std::size_t view = 0; view < joints_.size(); ++view) {
      const Transform here = pose(unknowns_, view);
      for (Eigen::Index k = 0; k < unknowns_.size(); ++k) {
        const Eigen::Index of_view = (k - geometry_numbers) / joint_numbers;
        if (k >= geometry_numbers && of_view != static_cast<Eigen::Index>(view)) continue;
        Eigen::VectorXd other = unknowns_;
        other[k] += difference;
        motions.block<6, 1>(6 * static_cast<Eigen::Index>(view), k) =
            log_of(here.inverse() * pose(other, view)) / difference;
      }
    }
    return motions;
  }

  void step(const PoseEquations& sum) {
    const Eigen::MatrixXd motions = motions_by_unknowns();
    const Eigen::VectorXd prior = prior_deviations_.array().square().inverse();
    information_ = motions.transpose() * sum.information * motions;
    information_.diagonal() += prior;
    const Eigen::VectorXd gradient =
        motions.transpose() * sum.gradient + Eigen::VectorXd(prior.array() * unknowns_.array());
    unknowns_ -= information_.ldlt().solve(gradient);
  }

  [[nodiscard]] Calibration result(const PoseEquations& before, const PoseEquations& after) const {
    Calibration calibration{chain(unknowns_), {}, {}, {}};
    // The matcher's error in a view affects all of its pairs, which the sum treats as independent: on
    // simulated bays, the errors of lengths are three times the computed deviation (docs/mapping.md).
    constexpr double understated = 3.0;
    const Eigen::MatrixXd covariance =
        information_.ldlt().solve(Eigen::MatrixXd::Identity(unknowns_.size(), unknowns_.size()));
    const Eigen::VectorXd deviations = understated * covariance.diagonal().cwiseSqrt();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      constexpr double little = 0.5;  // share of the prior deviation
      const auto at = static_cast<Eigen::Index>(i);
      const double unit = kinds.at(i).is_turn ? rad_per_deg : m_per_mm;
      calibration.numbers.push_back({.name = std::string(kinds.at(i).name),
                                     .unit = kinds.at(i).is_turn ? "deg" : "mm",
                                     .change = unknowns_[at] / unit,
                                     .deviation = deviations[at] / unit,
                                     .held = deviations[at] < little * prior_deviations_[at]});
    }
    for (std::size_t i = 0; i < joints_.size(); ++i)
      calibration.views.push_back({joint_error(unknowns_, i), before.views[i], after.views[i]});
    calibration.doubt = doubt_of(calibration);
    return calibration;
  }

  [[nodiscard]] std::string doubt_of(const Calibration& calibration) const {
    constexpr double least_agreeing = 0.5;
    for (const CalibratedNumber& number : calibration.numbers) {
      if (!number.held) return fmt::format("the views do not determine '{}'", number.name);
    }
    for (std::size_t i = 0; i < calibration.views.size(); ++i) {
      const ViewResiduals& view = calibration.views[i].after;
      if (view.neighbours == 0) return fmt::format("{} shares no surface with another one", names_[i]);
      if (view.share() < least_agreeing)
        return fmt::format("only {:.0f} % of the overlap of {} with others lies on the same surfaces",
                           100.0 * view.share(), names_[i]);
    }
    return {};
  }

  OverlappingViews by_surfaces_;
  PanTiltChain given_;
  std::vector<PanTilt> joints_;
  std::vector<std::string> names_;
  Eigen::VectorXd unknowns_;  // changes of the geometry, then errors of pan and tilt for each view
  Eigen::VectorXd prior_deviations_;
  Eigen::MatrixXd information_;
};

void require_turned(std::span<const MapView> views, double PanTilt::*angle, std::string_view joint) {
  constexpr double least_deg = 10.0;
  const auto [low, high] =
      std::ranges::minmax_element(views, {}, [angle](const MapView& view) { return view.joints.*angle; });
  if ((*high).joints.*angle - (*low).joints.*angle >= least_deg) return;
  throw Error("views", fmt::format("{} turns by less than {} degrees among them", joint, least_deg),
              "take views from more angles");
}

}  // namespace

Calibration calibrate(std::span<const MapView> views, const PanTiltChain& given,
                      const CalibrationOptions& options) {
  check_options(options);
  constexpr std::size_t least_views = 3;
  if (views.size() < least_views)
    throw Error("views", fmt::format("{} views are too few for a calibration", views.size()),
                "take a dozen, spread over the robot's range");
  require_turned(views, &PanTilt::pan_deg, "pan");
  require_turned(views, &PanTilt::tilt_deg, "tilt");
  return Estimation(views, given, options).run();
}

CalibrationResiduals sum_of_residuals(const Calibration& calibration) {
  const auto add = [](const ViewResiduals& view, ViewResiduals& sum) {
    sum.neighbours += view.neighbours;
    sum.compared += view.compared;
    sum.agreeing += view.agreeing;
    sum.squares += view.squares;
  };
  CalibrationResiduals sum;
  for (const CalibratedView& view : calibration.views) {
    add(view.before, sum.before);
    add(view.after, sum.after);
  }
  return sum;
}

}  // namespace rva
