// Findings of a detection, in the same form for every method.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/enum_names.hpp"
#include "core/options.hpp"
#include "detect/regions/comparison.hpp"
#include "detect/regions/regions.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// How a region changed.
enum class ChangeKind {
  added,       ///< nearer than before, or depth went missing, as behind glass and on bare metal
  removed,     ///< farther than before, or depth appeared where there was none
  appearance,  ///< brighter or darker than before; depth shows no reliable change
};
template <>
inline constexpr auto enum_names<ChangeKind> = std::to_array<EnumName<ChangeKind>>({
    {ChangeKind::added, "added"},
    {ChangeKind::removed, "removed"},
    {ChangeKind::appearance, "appearance"},
});

/// Which images support a finding.
struct Evidence {
  bool depth = true;
  bool appearance = false;  ///< infrared or colour images differ there

  bool operator==(const Evidence&) const = default;
};

/// One change, of a single kind. Pixels are those of the final depth image, positions are in the final depth
/// camera's frame. Quantities that a method does not provide are empty.
struct Finding {
  int id = 0;  ///< from 1, most suspicious first
  ChangeKind kind = ChangeKind::added;
  Box box;
  std::vector<std::uint32_t> pixels;  ///< changed pixels, as indices in row-major order
  Eigen::Vector2d centroid{0, 0};     ///< mean of the pixels
  /// The centroid at the median depth of the region, where pixels without depth after count with that before.
  std::optional<Eigen::Vector3d> position_m;
  std::optional<std::array<double, 2>> size_mm;  ///< the box's width and height at that depth
  /// Median decrease of depth over the region, along z: positive for `added`, negative for `removed`. Empty
  /// if less than half of the region has depth both before and after, or if the sign contradicts the kind.
  std::optional<double> height_mm;
  /// Height above the surface around it, along z, above 0: of an added finding after, of a removed one before
  /// (height_above_surroundings.hpp).
  std::optional<double> above_surroundings_mm{};
  /// Height of its top above the surface that it lies on, at right angles to it (HeightAboveSurroundings).
  std::optional<double> top_above_surroundings_mm{};
  bool top_is_least = false;  ///< whether it may be higher (HeightAboveSurroundings::at_least)
  /// True if depth changed by much more than that, since a farther surface was seen there before, or is seen
  /// now. False also where either is empty.
  bool background_jump = false;
  std::optional<double> score;  ///< larger is more suspicious; comparable within a method
  std::optional<double> p_value;
  /// For an added finding, the id of a removed finding of about the same size (moved_things.hpp).
  std::optional<int> moved_from;
  Evidence evidence;
};

/// Time taken by each stage, milliseconds.
struct Runtime {
  double load_ms = 0.0;
  double statistics_ms = 0.0;
  double detect_ms = 0.0;
  double regions_ms = 0.0;
  double total_ms = 0.0;
};

/// Options by their names in JSON, with the values that were used.
using Parameters = std::vector<std::pair<std::string, std::variant<int, double>>>;

/// Adds all options of a struct.
template <typename Options>
void state(const Options& options, Parameters& parameters) {
  Options::describe(options, [&](const auto& value, const OptionField& field) {
    parameters.emplace_back(json_name(field), value);
  });
}

/// All findings of a comparison, with the conditions under which they were made.
struct Findings {
  std::string method;
  Parameters parameters;  ///< every option that affected the result
  std::size_t initial_frames = 0;
  std::size_t final_frames = 0;
  Transform final_from_initial = Transform::Identity();
  Coverage coverage;
  Runtime runtime;
  /// Share of the final depth image in which infrared or colour images were compared; empty if none were.
  std::optional<double> appearance_judged{};
  std::vector<Finding> findings;  ///< most suspicious first; those supported by appearance alone come last
};

/// Sets position and size of a finding from its centroid, its box and the median of `depths_m`; does nothing
/// if there are no depths.
/// @param depths_m depths of its pixels, metres; reordered
void locate(const Intrinsics& camera, std::vector<float>& depths_m, Finding& finding);

/// Sets the heights of an added or removed finding above the surface around it, and whether the background
/// jumps there, from depth before and after; does nothing where depth does not show them.
/// @param changed every changed pixel, including those of the finding
/// @param camera  of both depth images
void measure_surroundings(const Image<float>& initial_m, const Image<float>& final_m, const Mask& changed,
                          const Intrinsics& camera, Finding& finding);

/// Groups the changed pixels of a comparison into regions and measures them; the most suspicious come first.
/// Pixels that came nearer and pixels that went farther are never grouped, however close they are.
///
/// If evidence is rarity, the score is that of the rarest pixel, and the p-value the probability that an
/// inspection without any change shows something as rare. Otherwise the score is the mean evidence of the
/// region's pixels times the square root of their number, which for independent pixels is their summed
/// evidence in standard deviations. Neighbouring pixels are not independent, so this score ranks findings but
/// is no probability.
[[nodiscard]] std::vector<Finding> find_findings(const Comparison& comparison, const RegionOptions& options,
                                                 const Intrinsics& camera);

/// The content of `detections.json` (docs/detection.md).
[[nodiscard]] nlohmann::ordered_json json_of(const Findings& findings);

}  // namespace rva
