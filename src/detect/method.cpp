#include "detect/method.hpp"

#include <algorithm>
#include <array>

#include "core/options.hpp"
#include "detect/static_method.hpp"
#include "detect/thesis/octree_detection.hpp"

namespace rva {
namespace {

struct Method {
  DetectionMethod method;
  std::vector<std::string> (*options)();
};

template <typename... Options>
std::vector<std::string> names_in() {
  std::vector<std::string> names;
  const auto add = [&](const auto& /*value*/, const OptionField& field) { names.emplace_back(field.name); };
  (Options::describe(Options{}, add), ...);
  return names;
}

constexpr auto calibrated_options = names_in<FrameOptions, CalibratedOptions, RegionOptions>;

constexpr std::array methods{
    Method{DetectionMethod::automatic, calibrated_options},
    Method{DetectionMethod::constant, names_in<ConstantOptions, RegionOptions>},
    Method{DetectionMethod::gaussian, names_in<FrameOptions, GaussianOptions, RegionOptions>},
    Method{DetectionMethod::calibrated, calibrated_options},
    Method{DetectionMethod::spatial, calibrated_options},
    Method{DetectionMethod::octree, names_in<OctreeOptions, RegionOptions>}};

}  // namespace

bool shows_both_ends(DetectionMethod method) {
  return method == DetectionMethod::automatic || method == DetectionMethod::calibrated ||
         method == DetectionMethod::spatial;
}

std::vector<std::string> options_of(DetectionMethod method) {
  return std::ranges::find(methods, method, &Method::method)->options();
}

}  // namespace rva
