#include "cli/simulated_view.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

constexpr std::string_view simulated = "sim:";
constexpr std::string_view joints_file = ",joints=";

PanTilt read_joints(const std::string& path) {
  std::istringstream text(read_text_file(path));
  PanTilt joints;
  constexpr double most_deg = 180.0;
  if (text >> joints.pan_deg >> joints.tilt_deg && std::abs(joints.pan_deg) <= most_deg &&
      std::abs(joints.tilt_deg) <= most_deg)
    return joints;
  throw Error(printable(path), "does not contain two angles", "write pan and tilt in degrees into it");
}

}  // namespace

std::filesystem::path scene_file(const std::string& scene) {
  namespace fs = std::filesystem;
  std::error_code failure;
  if (scene.find_first_of("/.") != scene.npos || fs::exists(scene, failure)) return scene;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path shipped = fs::path("data/scenes") / (scene + ".yaml");
  for (const fs::path& file : {shipped, program.parent_path().parent_path() / shipped}) {
    if (fs::is_regular_file(file, failure)) return file;
  }
  return scene;
}

SimulatedView parse_simulated_view(const std::string& camera) {
  if (!camera.starts_with(simulated) || camera.size() == simulated.size())
    throw UsageError(printable(camera), "is not a camera that a robot can carry",
                     "give sim:SCENE or realsense[:SERIAL]");
  const std::size_t joints = camera.rfind(joints_file);
  if (joints == std::string::npos) return {camera.substr(simulated.size()), ""};
  if (camera.size() == joints + joints_file.size())
    throw UsageError(printable(camera), "does not name a file of joint angles", "give sim:SCENE,joints=FILE");
  return {camera.substr(simulated.size(), joints - simulated.size()),
          camera.substr(joints + joints_file.size())};
}

std::function<PanTilt()> joints_of(const SimulatedView& view, std::function<PanTilt()> robot_joints) {
  if (view.joints.empty()) return robot_joints;
  return [file = view.joints] { return read_joints(file); };
}

}  // namespace rva::cli
