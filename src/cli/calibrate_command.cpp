#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/calibration.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct CalibrateArguments {
  std::vector<std::string> captures;
  std::optional<std::string> geometry;
  std::string out;
  CalibrationOptions options;
  bool overwrite = false;
  bool json = false;
};

// All captures must come from one camera on one robot whose foot did not move.
void require_same_robot(const CaptureInfo& first, const CaptureInfo& info, const std::string& name) {
  const auto base = [](const CaptureInfo& of) { return of.pose ? of.pose->base : std::nullopt; };
  const auto device = [](const CaptureInfo& of) { return of.camera.value_or(CameraInfo{}); };
  if (!base(info))
    throw Error(name, "does not state where it was taken (pose.base)", "give captures of one rva map");
  if (base(info) != base(first))
    throw Error(name, "was not taken from the same position as the others (pose.base)",
                "give captures of one rva map");
  if (info.depth != first.depth || device(info).serial != device(first).serial ||
      device(info).baseline_m != device(first).baseline_m)
    throw Error(name, "was not taken by the same camera as the others", "give captures of one rva map");
}

std::vector<MapView> load_views(const std::vector<std::string>& captures) {
  const Progress progress = terminal_progress();
  std::vector<MapView> views;
  std::optional<CaptureInfo> first;
  std::set<fs::path> seen;
  for (const std::string& path : captures) {
    std::error_code ignored;
    if (!seen.insert(fs::weakly_canonical(path, ignored)).second)
      throw Error(printable(path), "is given twice", "give each view once");
    const std::unique_ptr<Capture> capture = open_capture(path);
    if (!first) first = capture->info();
    require_same_robot(*first, capture->info(), printable(path));
    views.push_back(load_map_view(*capture, printable(path)));
    if (progress) progress("reading", views.size(), captures.size());
  }
  return views;
}

/// Sums over all views.
struct ResidualsBeforeAndAfter {
  ViewResiduals before;
  ViewResiduals after;
};

ResidualsBeforeAndAfter sum_of(const Calibration& calibration) {
  const auto add = [](const ViewResiduals& view, ViewResiduals& sum) {
    sum.neighbours += view.neighbours;
    sum.compared += view.compared;
    sum.agreeing += view.agreeing;
    sum.squares += view.squares;
  };
  ResidualsBeforeAndAfter sum;
  for (const CalibratedView& view : calibration.views) {
    add(view.before, sum.before);
    add(view.after, sum.after);
  }
  return sum;
}

using Json = nlohmann::ordered_json;

Json json_of(const ViewResiduals& residuals) {
  return {{"agreeing", residuals.share()}, {"residual_px", residuals.residual_px()}};
}

void print_json(const Calibration& calibration, const std::vector<MapView>& views) {
  const ResidualsBeforeAndAfter sum = sum_of(calibration);
  Json json = {{"before", json_of(sum.before)},
               {"after", json_of(sum.after)},
               {"numbers", Json::array()},
               {"views", Json::array()}};
  for (const CalibratedNumber& number : calibration.numbers)
    json["numbers"].push_back({{"name", number.name},
                               {"unit", number.unit},
                               {"change", number.change},
                               {"deviation", number.deviation}});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const CalibratedView& view = calibration.views[i];
    json["views"].push_back({{"capture", views[i].name},
                             {"pan_error_deg", view.joint_error.pan_deg},
                             {"tilt_error_deg", view.joint_error.tilt_deg},
                             {"neighbours", view.after.neighbours},
                             {"before", json_of(view.before)},
                             {"after", json_of(view.after)}});
  }
  print("{}", json_file_text(json, 2));
}

void print_table(const Calibration& calibration, const std::vector<MapView>& views) {
  print("{:36} {:>8}     {}\n", "against the geometry that was given", "change", "sigma");
  for (const CalibratedNumber& number : calibration.numbers)
    print("{:36} {:+8.2f} {:3} {:.2f}\n", number.name, number.change, number.unit, number.deviation);
  print("\n{:36} {:>6} {:>6} {:>9} {:>9}\n", "view", "pan", "tilt", "residual", "agreeing");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& [error, before, after] = calibration.views[i];
    print("{:36} {:+6.2f} {:+6.2f} {:6.2f} px {:7.0f} %\n", views[i].name, error.pan_deg, error.tilt_deg,
          after.residual_px(), 100.0 * after.share());
  }
  const ResidualsBeforeAndAfter sum = sum_of(calibration);
  print("\nOn the same surfaces: {:.0f} % before, {:.0f} % after.\n", 100.0 * sum.before.share(),
        100.0 * sum.after.share());
}

void require_replaceable(const fs::path& file, bool overwrite) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return;
  if (!overwrite) throw Error(printable(file), "already exists", "choose another name, or give --overwrite");
  try {
    if (fs::is_regular_file(fs::symlink_status(file, ignored))) {
      (void)load_robot_geometry(file);
      return;
    }
  } catch (const Error&) {  // reported below
  }
  throw Error(printable(file), "is not a robot's geometry, so it is not replaced", "choose another name");
}

void calibrate_robot(const CalibrateArguments& arguments) {
  require_replaceable(arguments.out, arguments.overwrite);
  check_options(arguments.options);
  const PanTiltChain given = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  const std::vector<MapView> views = load_views(arguments.captures);
  const Calibration calibration = calibrate(views, given, arguments.options);
  if (!calibration.doubt.empty())
    throw Error("views", calibration.doubt,
                "take more of them, over the whole range of the joints, in front of structured surfaces");
  throw_if_interrupted();
  replace_file(arguments.out, json_file_text(json_of(calibration.chain), 2));
  if (arguments.json)
    print_json(calibration, views);
  else
    print_table(calibration, views);
}

}  // namespace

void add_calibrate_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "calibrate", "finds where the robot's joints and camera are, from views at known joint angles");
  const auto arguments = std::make_shared<CalibrateArguments>();
  command
      .add_option("captures", arguments->captures,
                  "views from one position, as rva map writes them to .views")
      ->required()
      ->type_name("CAPTURE");
  command
      .add_option("--geometry", arguments->geometry, "as it was measured; by default as the robot is built")
      ->type_name("FILE");
  command.add_option("--out", arguments->out, "the robot's geometry, for rva map --geometry")
      ->required()
      ->type_name("FILE");
  add_flags(command, arguments->options);
  command.add_flag("--overwrite", arguments->overwrite, "replace FILE");
  command.add_flag("--json", arguments->json, "print JSON");
  command.callback([arguments] { calibrate_robot(*arguments); });
}

}  // namespace rva::cli
