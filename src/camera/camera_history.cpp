#include "camera/camera_history.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
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

nlohmann::ordered_json json_of(const JudgedCheck& judged) {
  const auto& [check, judgement, history] = judged;
  nlohmann::ordered_json json{{"format", "rva-camera-check"}, {"version", 1},
                              {"taken_at", check.taken_at},   {"frames", check.frames},
                              {"known", judgement.known},     {"fit", judgement.fit},
                              {"earlier", judgement.earlier}};
  if (check.temperature_c) json["temperature_c"] = *check.temperature_c;
  json["quantities"] = nlohmann::ordered_json::array();
  for (const CheckedQuantity& quantity : judgement.quantities) {
    nlohmann::ordered_json entry{{"name", quantity.name}, {"value", quantity.value}, {"fit", quantity.fit}};
    if (quantity.low) entry["low"] = *quantity.low;
    if (quantity.high) entry["high"] = *quantity.high;
    json["quantities"].push_back(std::move(entry));
  }
  json["history"] = history.string();
  return json;
}

}  // namespace rva
