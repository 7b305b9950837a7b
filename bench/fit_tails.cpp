// Fits the prior slopes of the false alarm tails of unchanged images, over random simulated bays and cameras.
//
// usage: rva_fit_tails fit FILE [INSPECTIONS [FIRST_SEED [CAMERAS]]]
//        rva_fit_tails check FILE
//
// `fit` writes FILE. `check` compares the program's constants with FILE, and exits with status 1 if a slope
// or a weight lies outside its interval.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "detect/appearance/appearance_evidence.hpp"
#include "detect/spatial/lit_capture.hpp"
#include "detect/spatial/spatial_comparison.hpp"
#include "detect/spatial/spatial_detection.hpp"
#include "detect/spatial/still_evidence.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/prior_slope_fit.hpp"
#include "evaluate/robot_side.hpp"
#include "geometry/stereo_scale.hpp"
#include "sim/sensor/camera_models.hpp"
#include "views/fused_view.hpp"
#include "views/view_check.hpp"

namespace fs = std::filesystem;

namespace {

using namespace rva;

constexpr int frames = 10;
constexpr int dithers = 4;

/// The program's tails, in the order of tails().
enum Kind : std::size_t {
  still_change_reliable,
  still_change_unreliable,
  still_loss_reliable,
  still_loss_unreliable,
  single_change,
  single_loss,
  moved_change_reliable,
  moved_change_unreliable,
  bumped_change_reliable,
  bumped_change_unreliable,
  between_dots,
  with_pairs,
  still_pair,
  under_lamp,
};

struct Tail {
  std::string_view name;
  PriorSlope held;  ///< the program's constants
};

const std::vector<Tail>& tails() {
  static const std::vector<Tail> all{
      {"still, change, reliable", slopes_of_means.change.reliable},
      {"still, change, unreliable", slopes_of_means.change.unreliable},
      {"still, loss, reliable", slopes_of_means.loss.reliable},
      {"still, loss, unreliable", slopes_of_means.loss.unreliable},
      {"single frames, change", slopes_of_single_frames.change.reliable},
      {"single frames, loss", slopes_of_single_frames.loss.reliable},
      {"moved, change, reliable", slopes_of_moved_cameras.change.reliable},
      {"moved, change, unreliable", slopes_of_moved_cameras.change.unreliable},
      {"bumped, change, reliable", slopes_of_bumped_cameras.change.reliable},
      {"bumped, change, unreliable", slopes_of_bumped_cameras.change.unreliable},
      {"infrared, between dots", tail_between_dots.slope},
      {"infrared, with pairs", tail_with_pairs.slope},
      {"infrared, still", tail_of_still_pair.slope},
      {"infrared, under a lamp", tail_under_lamp.slope},
  };
  return all;
}

using PeaksOfTails = std::vector<std::vector<float>>;

void append(std::vector<float>& to, const std::vector<float>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The captures of one side as the program compares them, and their true poses.
struct TakenSide {
  Captures whole;
  Captures lit;  ///< the same captures without depth outside the projector's light
  std::vector<Transform> world_from_camera;

  // The first `captures` captures, fused in the view of the first one.
  [[nodiscard]] DepthView view(std::size_t captures) const {
    std::vector<PlacedView> views;
    const Transform first_from_world = world_from_camera.front().inverse();
    for (std::size_t k = 0; k < captures; ++k)
      views.push_back({depth_view(*lit[k]), first_from_world * world_from_camera[k]});
    return fuse(views);
  }

  [[nodiscard]] DepthStatistics statistics(std::size_t count) const {
    Runtime ignored;
    return statistics_of(*lit.front(), count, {}, ignored);
  }

  [[nodiscard]] StereoScale stereo() const { return stereo_scale(lit.front()->info()); }
};

TakenSide take(const Scene& scene, const StereoSensorOptions& sensor, const RobotSideOptions& options,
               std::uint64_t seed, const fs::path& folder) {
  const RobotSide side = take_by_robot(scene, sensor, options, seed, folder);
  TakenSide taken{side.open(options.captures), {}, {}};
  for (const PanTilt& joints : side.rested)
    taken.world_from_camera.push_back(camera_at(scene, sensor, joints).world_from_camera());
  return taken;
}

/// One unchanged bay with two sides captured by the same camera.
struct UnchangedBay {
  UnchangedBay(std::uint64_t seed, CameraReturn how, const StereoSensorOptions& sensor,
               const RobotSideOptions& options) {
    const std::uint64_t stream = mix(seed, static_cast<std::uint64_t>(how));
    const MovedWing wing = random_moved_wing(stream, how);
    Scene unchanged = wing.before;
    unchanged.stand = wing.after.stand;
    before = take(wing.before, sensor, options, mix(stream, 1), room.path() / "before");
    after = take(unchanged, sensor, options, mix(stream, 2), room.path() / "after");
    LitSides lit = within_projector_field(before.whole, after.whole);
    before.lit = std::move(lit.initial);
    after.lit = std::move(lit.final);
  }

  CaptureRoom room;
  TakenSide before;
  TakenSide after;
};

void add_still(const UnchangedBay& bay, PeaksOfTails& peaks) {
  const StereoScale stereo = bay.after.stereo();
  const auto of_frames = [&](std::size_t count) {
    return peaks_of(disparity_change(bay.before.statistics(count), bay.after.statistics(count), stereo),
                    stereo);
  };
  const CalibratedPeaks means = of_frames(frames);
  append(peaks[still_change_reliable], means.change.reliable);
  append(peaks[still_change_unreliable], means.change.unreliable);
  append(peaks[still_loss_reliable], means.loss.reliable);
  append(peaks[still_loss_unreliable], means.loss.unreliable);
  const CalibratedPeaks singles = of_frames(1);
  append(peaks[single_change], singles.change.reliable);
  append(peaks[single_change], singles.change.unreliable);
  append(peaks[single_loss], singles.loss.reliable);
  append(peaks[single_loss], singles.loss.unreliable);
}

void add_moved(const UnchangedBay& bay, std::size_t captures, KnownMotion known, PeaksOfTails& peaks) {
  const DepthView before = bay.before.view(captures);
  const DepthView after = bay.after.view(captures);
  const Registration registration =
      known == KnownMotion::bumped ? register_near_views(before, after) : register_views(before, after);
  if (!registration.trusted()) return;
  const SpatialChange change = change_from_elsewhere(before, after, registration, known);
  const CalibratedPeaks found = peaks_of(change.change, bay.after.stereo());
  const bool bumped = known == KnownMotion::bumped;
  append(peaks[bumped ? bumped_change_reliable : moved_change_reliable], found.change.reliable);
  append(peaks[bumped ? bumped_change_unreliable : moved_change_unreliable], found.change.unreliable);
}

// Empty if the registration of the views is refused.
std::optional<SpatialDetection> compared_by_depth(const UnchangedBay& bay) {
  try {
    return detect_spatial(bay.before.lit, bay.after.lit, {}, {});
  } catch (const RegistrationRefused&) {
    return std::nullopt;
  }
}

void add_infrared(const UnchangedBay& bay, std::optional<Kind> projector, std::optional<Kind> lamp,
                  PeaksOfTails& peaks) {
  const std::optional<SpatialDetection> depth = compared_by_depth(bay);
  if (!depth) return;
  std::vector<std::string> warnings;
  for (const auto& [light, tail] : {std::pair(Light::projector, projector), std::pair(Light::lamp, lamp)}) {
    if (!tail) continue;
    if (const auto change = change_between(bay.before.whole, bay.after.whole, depth->placed,
                                           depth->registration.initial_from_final, light, warnings))
      append(peaks[*tail], peaks_of(change->change));
  }
}

void add_still_infrared(const UnchangedBay& bay, PeaksOfTails& peaks) {
  std::vector<std::string> warnings;
  if (const auto change = still_change_between(*bay.before.whole.front(), *bay.after.whole.front(),
                                               bay.after.view(1), Light::projector, warnings))
    append(peaks[still_pair], peaks_of(change->change));
}

// The peaks of one bay's unchanged images, for every tail.
PeaksOfTails peaks_of_inspection(std::uint64_t seed, const StereoSensorOptions& sensor) {
  PeaksOfTails peaks(tails().size());
  const UnchangedBay still(seed, CameraReturn::exact, sensor, {.captures = 1, .frames = frames});
  add_still(still, peaks);
  add_still_infrared(still, peaks);
  const int elsewhere = seed % 2 == 0 ? 1 : dithers;
  add_moved(UnchangedBay(seed, CameraReturn::elsewhere, sensor, {.captures = elsewhere, .frames = frames}),
            static_cast<std::size_t>(elsewhere), KnownMotion::moved, peaks);
  const UnchangedBay near(seed, CameraReturn::near, sensor, {.captures = dithers, .frames = frames});
  add_moved(near, 1, KnownMotion::bumped, peaks);
  add_infrared(near, between_dots, {}, peaks);
  const UnchangedBay rest(
      seed, CameraReturn::rest, sensor,
      {.captures = dithers, .frames = frames, .rest_error_deg = half_a_step_deg, .lamp = true});
  add_infrared(rest, with_pairs, under_lamp, peaks);
  return peaks;
}

double rounded(double value) { return std::round(100.0 * value) / 100.0; }

nlohmann::ordered_json json_of(const PriorSlopeFit& fit) {
  return {{"slope", rounded(fit.most_probable.slope)},
          {"slope_95", {rounded(fit.slope.low), rounded(fit.slope.high)}},
          {"peaks", rounded(fit.most_probable.peaks)},
          {"peaks_95", {rounded(fit.peaks.low), rounded(fit.peaks.high)}},
          {"images", fit.images},
          {"peaks_seen", fit.seen}};
}

void fit(const fs::path& file, int inspections, std::uint64_t first_seed, const std::string& cameras) {
  const std::function<StereoSensorOptions(std::uint64_t)> sensor_of = camera_of_each(cameras);
  std::vector<PeaksOfTails> of_inspections(static_cast<std::size_t>(inspections));
  parallel_bands(inspections, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      of_inspections[static_cast<std::size_t>(i)] = peaks_of_inspection(seed, sensor_of(seed));
      fmt::print(stderr, "bay {} done\n", seed);
    }
  });
  nlohmann::ordered_json json{{"format", "rva-usual-tails"}, {"version", 1},
                              {"cameras", cameras},          {"first_seed", first_seed},
                              {"inspections", inspections},  {"onset", FalseAlarmTail::onset}};
  for (std::size_t tail = 0; tail < tails().size(); ++tail) {
    std::vector<std::vector<float>> images;
    for (PeaksOfTails& of_inspection : of_inspections) images.push_back(std::move(of_inspection[tail]));
    json["tails"][std::string(tails()[tail].name)] = json_of(fit_prior_slope(images));
  }
  write_file(file, json_file_text(json));
}

bool check(const fs::path& file) {
  const nlohmann::json document = parse_json(read_text_file(file), file.string());
  const JsonObject fitted = JsonObject(document, file.string()).object("tails");
  bool all_fit = true;
  fmt::print("{:26} {:>16} {:>24} {:>16} {:>24}\n", "tail", "slope, program", "fitted (95 %)",
             "peaks, program", "fitted (95 %)");
  for (const auto& [name, held] : tails()) {
    const JsonObject tail = fitted.object(std::string(name).c_str());
    const auto slope = tail.numbers("slope_95", 2);
    const auto peaks = tail.numbers("peaks_95", 2);
    const bool fits =
        slope[0] <= held.slope && held.slope <= slope[1] && peaks[0] <= held.peaks && held.peaks <= peaks[1];
    fmt::print("{:26} {:16.2f} {:>24} {:16.2f} {:>24}{}\n", name, held.slope,
               fmt::format("{:.2f} ({:.2f} to {:.2f})", tail.number("slope"), slope[0], slope[1]), held.peaks,
               fmt::format("{:.1f} ({:.1f} to {:.1f})", tail.number("peaks"), peaks[0], peaks[1]),
               fits ? "" : "  does not fit");
    all_fit = all_fit && fits;
  }
  return all_fit;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "check") return check(arguments[1]) ? 0 : 1;
    if (arguments.size() >= 2 && arguments.size() <= 5 && arguments[0] == "fit") {
      const auto argument = [&](std::size_t k, const char* otherwise) {
        return arguments.size() > k ? arguments[k] : std::string(otherwise);
      };
      fit(arguments[1], std::stoi(argument(2, "30")), std::stoull(argument(3, "1100001")),
          argument(4, "random:24"));
      return 0;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_fit_tails: {}\n", error.what());
    return 2;
  }
  fmt::print(stderr,
             "usage: rva_fit_tails fit FILE [INSPECTIONS [FIRST_SEED [CAMERAS]]]\n"
             "       rva_fit_tails check FILE\n");
  return 2;
}
