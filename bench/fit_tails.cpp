// Fits how the tails of unchanged images usually fall off, over simulated bays and cameras drawn by chance.
//
// usage: rva_fit_tails fit FILE [INSPECTIONS [FIRST_SEED [CAMERAS]]]
//        rva_fit_tails check FILE
//
// `fit` writes FILE. `check` compares what the program holds with FILE, and exits with 1 where a slope or a
// weight lies outside of its interval.
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

#include "cloud/appearance_evidence.hpp"
#include "cloud/fused_view.hpp"
#include "cloud/spatial_comparison.hpp"
#include "cloud/spatial_detection.hpp"
#include "cloud/still_evidence.hpp"
#include "cloud/view_check.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "evaluate/usual_slope_fit.hpp"
#include "robot/dither.hpp"
#include "sim/sensor/camera_models.hpp"

namespace fs = std::filesystem;

namespace {

using namespace rva;

constexpr int frames = 10;
constexpr std::size_t dithers = 4;

/// The tails of the program, in the order of tails().
enum Kind : std::size_t {
  still_change_sure,
  still_change_unsure,
  still_loss_sure,
  still_loss_unsure,
  single_change,
  single_loss,
  moved_change_sure,
  moved_change_unsure,
  bumped_change_sure,
  bumped_change_unsure,
  between_dots,
  with_pairs,
  still_pair,
  under_lamp,
};

struct Tail {
  std::string_view name;
  UsualSlope held;  ///< by the program
};

const std::vector<Tail>& tails() {
  static const std::vector<Tail> all{
      {"still, change, sure", slopes_of_means.change.sure},
      {"still, change, unsure", slopes_of_means.change.unsure},
      {"still, loss, sure", slopes_of_means.loss.sure},
      {"still, loss, unsure", slopes_of_means.loss.unsure},
      {"single frames, change", slopes_of_single_frames.change.sure},
      {"single frames, loss", slopes_of_single_frames.loss.sure},
      {"moved, change, sure", slopes_of_moved_cameras.change.sure},
      {"moved, change, unsure", slopes_of_moved_cameras.change.unsure},
      {"bumped, change, sure", slopes_of_bumped_cameras.change.sure},
      {"bumped, change, unsure", slopes_of_bumped_cameras.change.unsure},
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

/// One unchanged bay, captured twice by one camera.
class UnchangedBay {
 public:
  UnchangedBay(std::uint64_t seed, CameraReturn how, const StereoSensorOptions& sensor)
      : seed_(mix(seed, static_cast<std::uint64_t>(how))), sensor_(sensor) {
    const MovedWing wing = random_moved_wing(seed_, how);
    before_ = wing.before;
    after_ = wing.before;
    after_.stand = wing.after.stand;
  }

  [[nodiscard]] DepthStatistics statistics_before(int count) const { return statistics(before_, 1, count); }
  [[nodiscard]] DepthStatistics statistics_after(int count) const { return statistics(after_, 2, count); }

  // The views of a dithered side, fused in the first one.
  [[nodiscard]] DepthView view_before(std::size_t captures) const { return view(before_, 3, captures); }
  [[nodiscard]] DepthView view_after(std::size_t captures) const { return view(after_, 4, captures); }

  [[nodiscard]] RobotSide side_before(const RobotSideOptions& options, const fs::path& folder) const {
    return take_by_robot(before_, sensor_, options, mix(seed_, 5), folder / "before");
  }
  [[nodiscard]] RobotSide side_after(const RobotSideOptions& options, const fs::path& folder) const {
    return take_by_robot(after_, sensor_, options, mix(seed_, 6), folder / "after");
  }

  [[nodiscard]] double disparity_by_depth() const {
    const CaptureInfo info = SimulatedCamera(before_, sensor_, 0, ColorFrames::none).info();
    return disparity_m_px(info) / info.depth_unit_m;
  }

 private:
  [[nodiscard]] static DepthStatistics statistics_of(SimulatedCamera& camera, int count) {
    DepthStatistics statistics(camera.info().depth.width, camera.info().depth.height);
    for (int i = 0; i < count; ++i) statistics.add(camera.wait_for_frame()->depth);
    return statistics;
  }

  [[nodiscard]] DepthStatistics statistics(const Scene& scene, std::uint64_t stream, int count) const {
    SimulatedCamera camera(scene, sensor_, mix(seed_, stream), ColorFrames::none);
    return statistics_of(camera, count);
  }

  [[nodiscard]] DepthView view(const Scene& scene, std::uint64_t stream, std::size_t captures) const {
    const PanTilt middle{scene.stand.pan_deg, scene.stand.tilt_deg};
    std::vector<PlacedView> views;
    Transform first_from_world = Transform::Identity();
    for (const PanTilt& joints : dithered(middle, static_cast<int>(captures), {})) {
      SimulatedCamera camera(scene, sensor_, mix(mix(seed_, stream), views.size()), ColorFrames::none,
                             [joints] { return joints; });
      const CaptureInfo info = camera.info();
      DepthView of_capture =
          depth_view(statistics_of(camera, frames), info.depth, info.depth_unit_m, disparity_m_px(info));
      if (views.empty()) first_from_world = camera.world_from_camera().inverse();
      views.push_back({std::move(of_capture), first_from_world * camera.world_from_camera()});
    }
    return fuse(views);
  }

  std::uint64_t seed_;
  const StereoSensorOptions& sensor_;
  Scene before_;
  Scene after_;
};

void add_still(const UnchangedBay& bay, PeaksOfTails& peaks) {
  const auto of_frames = [&](int count) {
    return peaks_of(
        disparity_change(bay.statistics_before(count), bay.statistics_after(count), bay.disparity_by_depth()),
        bay.disparity_by_depth());
  };
  const CalibratedPeaks means = of_frames(frames);
  append(peaks[still_change_sure], means.change.sure);
  append(peaks[still_change_unsure], means.change.unsure);
  append(peaks[still_loss_sure], means.loss.sure);
  append(peaks[still_loss_unsure], means.loss.unsure);
  const CalibratedPeaks singles = of_frames(1);
  append(peaks[single_change], singles.change.sure);
  append(peaks[single_change], singles.change.unsure);
  append(peaks[single_loss], singles.loss.sure);
  append(peaks[single_loss], singles.loss.unsure);
}

void add_moved(const UnchangedBay& bay, std::size_t captures, KnownMotion known, PeaksOfTails& peaks) {
  const DepthView before = bay.view_before(captures);
  const DepthView after = bay.view_after(captures);
  const Registration registration =
      known == KnownMotion::bumped ? register_near_views(before, after) : register_views(before, after);
  if (!registration.trusted()) return;
  const SpatialChange change = change_from_elsewhere(before, after, registration, known);
  const CalibratedPeaks found = peaks_of(change.change, bay.disparity_by_depth());
  const bool bumped = known == KnownMotion::bumped;
  append(peaks[bumped ? bumped_change_sure : moved_change_sure], found.change.sure);
  append(peaks[bumped ? bumped_change_unsure : moved_change_unsure], found.change.unsure);
}

// Empty where too little holds the views together.
std::optional<SpatialDetection> compared_by_depth(const Captures& before, const Captures& after) {
  try {
    return detect_spatial(before, after, {}, {});
  } catch (const RegistrationRefused&) {
    return std::nullopt;
  }
}

void add_infrared(const UnchangedBay& bay, double rest_error_deg, std::optional<Kind> projector,
                  std::optional<Kind> lamp, PeaksOfTails& peaks) {
  const CaptureRoom room;
  const RobotSideOptions options{static_cast<int>(dithers), frames, rest_error_deg, lamp.has_value()};
  const Captures before = bay.side_before(options, room.path()).open(options.captures);
  const Captures after = bay.side_after(options, room.path()).open(options.captures);
  const std::optional<SpatialDetection> depth = compared_by_depth(before, after);
  if (!depth) return;
  std::vector<std::string> warnings;
  for (const auto& [light, tail] : {std::pair(Light::projector, projector), std::pair(Light::lamp, lamp)}) {
    if (!tail) continue;
    if (const auto change = change_between(before, after, depth->placed,
                                           depth->registration.initial_from_final, light, warnings))
      append(peaks[*tail], peaks_of(change->change));
  }
}

void add_still_infrared(const UnchangedBay& bay, PeaksOfTails& peaks) {
  const CaptureRoom room;
  const RobotSideOptions options{1, frames};
  const Captures before = bay.side_before(options, room.path()).open(1);
  const Captures after = bay.side_after(options, room.path()).open(1);
  const DepthView view = view_of(*after.front());
  std::vector<std::string> warnings;
  if (const auto change =
          still_change_between(*before.front(), *after.front(), view, Light::projector, warnings))
    append(peaks[still_pair], peaks_of(change->change));
}

// Collects the peaks of one bay's unchanged images, for every tail.
PeaksOfTails peaks_of_inspection(std::uint64_t seed, const StereoSensorOptions& sensor) {
  PeaksOfTails peaks(tails().size());
  const UnchangedBay still(seed, CameraReturn::exact, sensor);
  add_still(still, peaks);
  add_still_infrared(still, peaks);
  add_moved(UnchangedBay(seed, CameraReturn::elsewhere, sensor), seed % 2 == 0 ? 1 : dithers,
            KnownMotion::moved, peaks);
  const UnchangedBay near(seed, CameraReturn::near, sensor);
  add_moved(near, 1, KnownMotion::bumped, peaks);
  add_infrared(near, 0.0, between_dots, {}, peaks);
  add_infrared(UnchangedBay(seed, CameraReturn::rest, sensor), half_a_step_deg, with_pairs, under_lamp,
               peaks);
  return peaks;
}

double rounded(double value) { return std::round(100.0 * value) / 100.0; }

nlohmann::ordered_json json_of(const UsualSlopeFit& fit) {
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
    json["tails"][std::string(tails()[tail].name)] = json_of(fit_usual_slope(images));
  }
  write_file(file, json.dump(1) + "\n");
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
