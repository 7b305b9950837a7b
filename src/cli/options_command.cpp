#include <fmt/format.h>

#include "camera/check_standard.hpp"
#include "camera/noise.hpp"
#include "camera/realsense/realsense.hpp"
#include "classify/object_model.hpp"
#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "detect/detect.hpp"
#include "detect/findings/loose_parts.hpp"
#include "doctor/checkup.hpp"
#include "evaluate/study.hpp"
#include "inspect/inspector.hpp"
#include "map/calibration.hpp"
#include "map/map_cloud.hpp"
#include "map/pose_refinement.hpp"
#include "map/repeatability.hpp"
#include "map/repeatability_summary.hpp"
#include "measure/measure_options.hpp"
#include "plan/plan_match.hpp"
#include "robot/drive.hpp"
#include "server/web_server.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva::cli {
namespace {

template <typename Options>
void print_rows() {
  Options::describe(Options{}, [](const auto& value, const OptionField& field) {
    const std::string unit = field.unit.empty() ? "" : fmt::format(" {}", field.unit);
    print("| `--{}` | {}{} | {} to {}{} | {} |\n", field.name, value, unit, field.min, field.max, unit,
          field.help);
  });
}

template <typename... Options>
void print_table(const char* command) {
  print("\n## `{}`\n\n| option | default | range | what it does |\n| --- | --- | --- | --- |\n", command);
  (print_rows<Options>(), ...);
}

// docs/options.md is this text; a test compares the two.
void print_options() {
  print("# Options\n\nPrinted by `rva options` from the structs that define them.\n");
  print_table<DetectOptions, PlanOptions, LoosePartOptions, ModelOptions>("rva detect");
  print_table<NoiseOptions, CheckStandardOptions, RealSenseOptions>("rva noise");
  print_table<StereoSensorOptions>("rva simulate");
  print_table<StudyOptions>("rva evaluate");
  print_table<MapCloudOptions, RefinementOptions, RealSenseOptions>("rva map");
  print_table<CalibrationOptions>("rva calibrate");
  print_table<RealSenseOptions>("rva record");
  print_table<DoctorOptions, RealSenseOptions>("rva doctor");
  print_table<RepeatabilityOptions, RepeatabilityLimits, RealSenseOptions>("rva robot repeatability");
  print_table<ServerOptions, InspectorOptions, DriveOptions, RealSenseOptions, MeasureOptions>("rva serve");
}

}  // namespace

void add_options_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "options", "prints every numeric option with default, unit and range, as Markdown");
  command.callback(print_options);
}

}  // namespace rva::cli
