#include "views/registration_starts.hpp"

#include <array>
#include <cmath>

#include "core/units.hpp"

namespace rva {
namespace {

constexpr std::array turns_deg{-21.0, -14.0, -7.0, 0.0, 7.0, 14.0, 21.0};
constexpr std::array sideways_m{-0.45, -0.3, -0.15, 0.0, 0.15, 0.3, 0.45};
constexpr std::array forward_m{-0.3, 0.0, 0.3};
constexpr std::array tilts_deg{-10.0, -30.0};

Eigen::AngleAxisd about(const Eigen::Vector3d& axis, double angle_deg) { return {radians(angle_deg), axis}; }

}  // namespace

std::vector<Transform> starts_around(const Transform& initial_from_final) {
  std::vector<Transform> starts;
  for (const double tilt_deg : tilts_deg) {
    const Eigen::Vector3d down = about(Eigen::Vector3d::UnitX(), -tilt_deg) * Eigen::Vector3d::UnitY();
    const Eigen::Vector3d ahead = about(Eigen::Vector3d::UnitX(), -tilt_deg) * Eigen::Vector3d::UnitZ();
    for (const double turn_deg : turns_deg) {
      for (const double forward : forward_m) {
        for (const double sideways : sideways_m) {
          Transform move(Eigen::Translation3d(sideways * Eigen::Vector3d::UnitX() + forward * ahead));
          move.rotate(about(down, turn_deg));
          starts.push_back(initial_from_final * move);
        }
      }
    }
  }
  return starts;
}

}  // namespace rva
