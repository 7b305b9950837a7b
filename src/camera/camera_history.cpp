#include "camera/camera_history.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <vector>

#include "camera/camera_check.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::string file_name(const CaptureInfo& info) {
  const CameraInfo camera = info.camera.value_or(CameraInfo{});
  std::string name = camera.serial.empty() ? camera.model : camera.serial;
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '-');
  return (name.empty() ? "camera" : name) + ".jsonl";
}

std::vector<CameraCheck> earlier_checks(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  return parse_checks(read_text_file(file), printable(file));
}

void add_to_history(const fs::path& file, const CameraCheck& check) {
  std::error_code ignored;  // append_to_file() reports a folder that could not be created
  fs::create_directories(file.parent_path(), ignored);
  append_to_file(file, check_line(check) + "\n");
}

}  // namespace

JudgedCheck check_and_remember(Camera& camera, const fs::path& folder, std::size_t frames,
                               const CheckStandardOptions& options, const Progress& progress) {
  check_options(options);
  JudgedCheck judged{.check = {}, .judgement = {}, .history = folder / file_name(camera.info())};
  const std::vector<CameraCheck> earlier = earlier_checks(judged.history);
  judged.check = check_camera(camera, frames, progress);
  judged.judgement = judge(judged.check, earlier, options);
  judged.check.fit = judged.judgement.fit;
  add_to_history(judged.history, judged.check);
  return judged;
}

}  // namespace rva
