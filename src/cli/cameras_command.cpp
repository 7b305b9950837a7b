#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "camera/realsense/realsense.hpp"
#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The cameras that were found, and, if the search failed, why.
struct Cameras {
  std::vector<FoundCamera> found;
  std::string problem;
};

Cameras find_cameras() {
  try {
    return {realsense_cameras(), ""};
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

std::string uri_of(const FoundCamera& camera) { return "realsense:" + camera.serial; }

Json json_of(const Cameras& cameras) {
  Json json{{"format", "rva-cameras"}, {"version", 1}, {"cameras", Json::array()}};
  for (const FoundCamera& camera : cameras.found) {
    json["cameras"].push_back({{"uri", uri_of(camera)},
                               {"model", camera.model},
                               {"serial", camera.serial},
                               {"firmware", camera.firmware},
                               {"usb", camera.usb}});
  }
  if (!cameras.problem.empty()) json["problem"] = cameras.problem;
  return json;
}

void print_for_a_person(const Cameras& cameras) {
  for (const FoundCamera& camera : cameras.found) {
    print("{}  {}, firmware {}, USB {}{}\n", printable(uri_of(camera)), printable(camera.model),
          printable(camera.firmware), printable(camera.usb),
          camera.usb.starts_with("2") ? ", too slow for all frames: use a USB 3 port and cable" : "");
  }
  if (!cameras.problem.empty()) {
    print("{}\n", cameras.problem);
  } else if (cameras.found.empty()) {
    print("no camera is plugged in\n");
  }
}

void list(bool json) {
  const Cameras cameras = find_cameras();
  if (json) {
    print("{}\n", json_text(json_of(cameras), 1));
  } else {
    print_for_a_person(cameras);
  }
}

}  // namespace

void add_cameras_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("cameras", "lists the cameras that are plugged in");
  const auto json = std::make_shared<bool>(false);
  command.add_flag("--json", *json, "print JSON instead of text");
  command.callback([json] { list(*json); });
}

}  // namespace rva::cli
