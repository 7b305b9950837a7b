#include "cli/camera_uri.hpp"

#include "camera/replay_camera.hpp"
#include "cli/simulated_view.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"

namespace rva::cli {

std::unique_ptr<Camera> open_camera(const std::string& uri, std::uint64_t seed,
                                    const CaptureOptions& recording, const RealSenseOptions& realsense) {
  const std::size_t colon = uri.find(':');
  const std::string kind = uri.substr(0, colon);
  const std::string path = colon == std::string::npos ? "" : uri.substr(colon + 1);
  if (kind == "sim" && !path.empty())
    return std::make_unique<SimulatedCamera>(load_scene(scene_file(path)), StereoSensorOptions{}, seed);
  if (kind == "replay" && !path.empty())
    return std::make_unique<ReplayCamera>(open_capture(path, recording), ReplayOptions{.paced = false});
  if (kind == "realsense" && (colon == std::string::npos || !path.empty()))
    return open_realsense(path, realsense);
  throw UsageError(printable(uri), "is not a camera", "give sim:SCENE, replay:PATH or realsense[:SERIAL]");
}

bool is_device(const std::string& uri) { return uri == "realsense" || uri.starts_with("realsense:"); }

}  // namespace rva::cli
