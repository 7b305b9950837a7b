#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "capture/capture_summary.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"

namespace rva::cli {
namespace {

struct InfoArguments {
  std::string capture;
  CaptureFlags captures;
  bool json = false;
};

void print_camera(const char* name, std::size_t frames, const Intrinsics& camera) {
  const auto field_deg = [](int pixels, double focal_px) {
    return degrees(2.0 * std::atan(0.5 * pixels / focal_px));
  };
  print("{:<8} {} frame(s) of {}x{}, fx {:.3f} fy {:.3f} cx {:.3f} cy {:.3f}, view {:.0f} x {:.0f} deg\n",
        name, frames, camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy,
        field_deg(camera.width, camera.fx), field_deg(camera.height, camera.fy));
}

void print_settings(const std::string& imager, const std::map<std::string, double>& settings) {
  std::string line;
  for (const auto& [name, value] : settings)
    line += fmt::format("{}{} {:.6g}", line.empty() ? "" : ", ", printable(name), value);
  print("set      {}: {}\n", printable(imager), line);
}

void print_pose(const Pose& pose) {
  print("pose     base {}", printable(pose.base.value_or("not stated")));
  if (pose.pan_deg) print(", pan {} deg", *pose.pan_deg);
  if (pose.tilt_deg) print(", tilt {} deg", *pose.tilt_deg);
  print("\n");
}

void print_model(const CameraInfo& camera) {
  print("camera   {}", printable(camera.model));
  if (!camera.serial.empty()) print(", serial {}", printable(camera.serial));
  if (camera.baseline_m) print(", baseline {:.6g} m", *camera.baseline_m);
  if (!camera.firmware.empty()) print(", firmware {}", printable(camera.firmware));
  if (!camera.usb.empty()) print(", USB {}", printable(camera.usb));
  print("\n");
  for (const auto& [imager, settings] : camera.settings) print_settings(imager, settings);
}

void print_for_a_person(const Capture& capture, const CaptureSummary& summary) {
  const CaptureInfo& info = capture.info();
  print("format   {}\n", info.format);
  print_camera("depth", capture.depth_frames(), info.depth);
  print("         unit {} m, {:.1f} % of pixels measured, {:.3f} to {:.3f} m\n", info.depth_unit_m,
        100.0 * summary.fill_rate, summary.nearest_m, summary.farthest_m);
  if (info.color) {
    print_camera("color", capture.color_frames(), *info.color);
  } else {
    print("color    {} frame(s), no intrinsics\n", capture.color_frames());
  }
  if (info.pose) print_pose(*info.pose);
  if (info.camera) print_model(*info.camera);
  if (!info.captured_at.empty()) print("taken    {}\n", printable(info.captured_at));
  if (summary.lost > 0) print("lost     {} frame(s) between these, by the camera's counter\n", summary.lost);
  for (const std::string& note : summary.notes) print("note     {}\n", note);
  print("sound    every frame was read\n");
}

void show(const InfoArguments& arguments) {
  const auto capture = open_capture(arguments.capture, arguments.captures.options());
  const CaptureSummary summary = summarize(*capture, terminal_progress());
  if (arguments.json) {
    print("{}\n", json_text(json_of(*capture, summary), 1));
  } else {
    print_for_a_person(*capture, summary);
  }
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "info", "reports what a capture contains, and reads all of it to check that it is sound");
  const auto arguments = std::make_shared<InfoArguments>();
  command.add_option("PATH", arguments->capture, "a capture")->required();
  arguments->captures.add_to(command);
  command.add_flag("--json", arguments->json, "print JSON instead of text");
  command.callback([arguments] { show(*arguments); });
}

}  // namespace rva::cli
