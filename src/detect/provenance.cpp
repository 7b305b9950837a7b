#include "detect/provenance.hpp"

#include <cassert>
#include <nlohmann/json.hpp>

#include "core/file_origin.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<CaptureSource>& side) {
  Json json = Json::array();
  for (const CaptureSource& source : side) {
    Json capture{{"path", source.path}, {"format", source.format}, {"frames", source.frames}};
    if (!source.serial.empty()) capture["serial"] = source.serial;
    if (!source.captured_at.empty()) capture["captured_at"] = source.captured_at;
    json.push_back(std::move(capture));
  }
  return json;
}

}  // namespace

std::vector<CaptureSource> sources_of(const std::vector<std::filesystem::path>& paths,
                                      const Captures& captures) {
  assert(paths.size() == captures.size());
  std::vector<CaptureSource> sources;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const CaptureInfo& info = captures[k]->info();
    sources.push_back({printable(paths[k]), info.format, captures[k]->depth_frames(),
                       info.camera ? info.camera->serial : "", info.captured_at});
  }
  return sources;
}

Json json_of(const Provenance& provenance) {
  Json json = provenance_json(provenance.created_at);
  json["initial"] = json_of(provenance.initial);
  json["final"] = json_of(provenance.final);
  return json;
}

}  // namespace rva
