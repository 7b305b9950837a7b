#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/calibration.hpp"
#include "map/calibration_views.hpp"

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
  const CalibrationResiduals sum = sum_of_residuals(calibration);
  print("\nOn the same surfaces: {:.0f} % before, {:.0f} % after.\n", 100.0 * sum.before.share(),
        100.0 * sum.after.share());
}

void calibrate_robot(const CalibrateArguments& arguments) {
  require_replaceable_geometry(arguments.out, arguments.overwrite);
  check_options(arguments.options);
  const PanTiltChain given = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  const std::vector<MapView> views =
      load_calibration_views({arguments.captures.begin(), arguments.captures.end()}, terminal_progress());
  const Calibration calibration = calibrate(views, given, arguments.options);
  if (!calibration.doubt.empty())
    throw Error("views", calibration.doubt,
                "take more of them, over the whole range of the joints, in front of structured surfaces");
  throw_if_interrupted();
  replace_file(arguments.out, json_file_text(json_of(calibration.chain), 2));
  if (arguments.json)
    print("{}", json_file_text(json_of(calibration, views), 2));
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
