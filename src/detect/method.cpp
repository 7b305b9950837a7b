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
  std::string_view name;
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
    Method{DetectionMethod::automatic, "auto", calibrated_options},
    Method{DetectionMethod::constant, "constant", names_in<ConstantOptions, RegionOptions>},
    Method{DetectionMethod::gaussian, "gaussian", names_in<FrameOptions, GaussianOptions, RegionOptions>},
    Method{DetectionMethod::calibrated, "calibrated", calibrated_options},
    Method{DetectionMethod::spatial, "spatial", calibrated_options},
    Method{DetectionMethod::octree, "octree", names_in<OctreeOptions, RegionOptions>}};

const Method& row_of(DetectionMethod method) { return *std::ranges::find(methods, method, &Method::method); }

}  // namespace

std::vector<DetectionMethod> detection_methods() {
  std::vector<DetectionMethod> all;
  for (const Method& row : methods) all.push_back(row.method);
  return all;
}

std::string_view name_of(DetectionMethod method) { return row_of(method).name; }

std::optional<DetectionMethod> detection_method_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(methods, name, &Method::name);
  return found == methods.end() ? std::nullopt : std::optional(found->method);
}

std::vector<std::string> options_of(DetectionMethod method) { return row_of(method).options(); }

}  // namespace rva
