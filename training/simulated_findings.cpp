// Simulates inspections and writes each finding as a classifier is shown it, with the object that it is.
//
// usage: rva_simulated_findings OUT FIRST_SEED INSPECTIONS CAMERA KINDS WAY
//
// CAMERA as of `rva evaluate --cameras`: "random:1" draws another camera for each inspection. KINDS:
//   catalogue      the debris catalogue
//   random-shapes  objects of random shape, which a classifier is to call unknown
//   unlisted       everyday objects outside the catalogue, never used for training
//
// WAY:
//   whole          five frames a side, compared as `rva detect` does, infrared images included: to judge by
//   quick          one frame a side, compared by depth alone, and each bay littered eight times with up to 60
//                  objects: many times as many findings in the same time, to train with
//
// Each inspection is of another bay in another light, with up to 36 objects. Every finding that was added is
// written twice: with the colour image, as in a lit bay, and with the infrared image alone, as in darkness.
// OUT/planes.f16 has the planes of all findings (finding_planes.hpp), 16-bit floats, one after the other;
// OUT/findings.json what each is. A run that is repeated continues after the last complete inspection.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "bench/arguments.hpp"
#include "classify/finding_planes.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/random.hpp"
#include "depth/mat_view.hpp"
#include "detect/detect.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/random_wing.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/debris/random_debris.hpp"
#include "scene/drop_zone.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/simulated_capture.hpp"

namespace {

using namespace rva;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// How inspections are simulated.
struct Way {
  std::string name;
  std::size_t frames = 0;  ///< of each side
  int objects = 0;         ///< the greatest number of a litter
  int litters = 0;         ///< for each bay
  bool infrared = false;   ///< whether infrared images are compared
};

Way way_named(const std::string& name) {
  if (name == "whole") return {name, 5, 36, 1, true};
  if (name == "quick") return {name, 1, 60, 8, false};
  throw std::invalid_argument("WAY is neither whole nor quick: " + name);
}

std::vector<std::string> kinds_named(const std::string& name) {
  std::vector<std::string> kinds;
  const auto add = [&](const std::vector<DebrisKind>& all) {
    for (const DebrisKind& kind : all)
      if ((kind.name == "random-shape") == (name == "random-shapes")) kinds.emplace_back(kind.name);
  };
  if (name == "catalogue")
    add(debris_catalogue());
  else if (name == "random-shapes" || name == "unlisted")
    add(unlisted_kinds());
  if (kinds.empty())
    throw std::invalid_argument("KINDS is not catalogue, random-shapes or unlisted: " + name);
  return kinds;
}

// Every second bay is furnished: brackets, hoses, cables, sealant, dirt and other coats.
Scene empty_bay(std::uint64_t seed) {
  BayFeatures furnished;
  if (seed % 2 == 0)
    furnished = {
        .brackets = true, .hoses = true, .cables = true, .sealant = true, .dirt = true, .skins = true};
  Scene bay = random_wing(seed, furnished);
  Random random(mix(seed, 0x116857));
  bay.lighting.visible = random.uniform(0.3, 1.0);
  return bay;
}

Scene littered(Scene bay, std::uint64_t seed, const std::vector<std::string>& kinds, int objects) {
  RandomDebris debris;
  debris.count = objects;
  debris.kinds = kinds;
  debris.seed = seed;
  debris.within = {bay.bay.min().head<2>(), bay.bay.max().head<2>()};
  debris.from_m = default_look_down_m(bay);
  (void)place_at_random(debris, bay);
  return bay;
}

std::unique_ptr<Capture> captured(SimulatedCamera& camera, std::size_t frames, const fs::path& folder) {
  OutputFolder out(folder, simulated_capture_files(), Existing::refuse);
  write_simulated_capture(camera, {}, {.frames = frames}, out, {});
  out.commit();
  return open_capture(folder);
}

// For each pixel within found_within_px of an object, the number of that object from 1.
cv::Mat near_objects(const std::vector<Target>& targets, cv::Size size) {
  cv::Mat numbers(size, CV_16UC1, cv::Scalar(0));
  for (std::size_t k = 0; k < targets.size(); ++k) {
    for (const std::uint32_t i : targets[k].pixels)
      numbers.at<std::uint16_t>(static_cast<int>(i) / size.width, static_cast<int>(i) % size.width) =
          static_cast<std::uint16_t>(k + 1);
  }
  const int side = 2 * found_within_px + 1;
  cv::Mat wide;
  cv::dilate(numbers, wide, cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side}));
  numbers.copyTo(wide, numbers > 0);
  return wide;
}

// What a finding is: the object with most of its pixels, if these are at least 30 %; nothing otherwise.
Json truth_of(const Finding& finding, const std::vector<Target>& targets, const cv::Mat& numbers) {
  std::map<std::uint16_t, std::size_t> counts;
  for (const std::uint32_t i : finding.pixels)
    ++counts[numbers.at<std::uint16_t>(static_cast<int>(i) / numbers.cols,
                                       static_cast<int>(i) % numbers.cols)];
  counts.erase(0);
  const auto most = std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; });
  constexpr double least_share = 0.3;
  if (most == counts.end() ||
      static_cast<double>(most->second) < least_share * static_cast<double>(finding.pixels.size()))
    return {{"kind", ""}};
  const Target& target = targets[most->first - 1U];
  return {{"kind", target.kind},
          {"visible_px", target.visible_px},
          {"distance_m", target.distance_m},
          {"objects", counts.size()}};
}

// The findings of an inspection while they are collected.
struct Collected {
  std::vector<cv::Mat> planes;
  Json findings = Json::array();
};

void collect(const Detection& detection, const Capture& final, const std::vector<Target>& targets,
             std::uint64_t seed, Collected& collected) {
  const auto lit = picture_of(final);
  const auto infrared = final.infrared_mean(Imager::left, Light::projector);
  if (!lit || !lit->is_color || !infrared) throw std::runtime_error("a capture lacks pictures");
  const FindingPicture dark = picture_of(*infrared);
  const cv::Mat numbers = near_objects(targets, {detection.final_m.width(), detection.final_m.height()});
  for (const Finding& finding : detection.findings.findings) {
    for (const FindingPicture* const picture : {&*lit, &dark}) {
      const auto planes = planes_of(finding, detection, final.info(), *picture);
      if (!planes) continue;
      Json described = truth_of(finding, targets, numbers);
      described["seed"] = seed;
      described["light"] = picture->is_color;
      described["change"] = name_of(finding.kind);
      collected.planes.push_back(*planes);
      collected.findings.push_back(described);
    }
  }
}

Detection compare(const Captures& initial, const Captures& final, const Way& way) {
  if (way.infrared) return detect(initial, final, {}, {}).detection;
  return detect_static(*initial.front(), *final.front(), {}, {}, {}).detection;
}

Collected inspect(std::uint64_t seed, const StereoSensorOptions& sensor,
                  const std::vector<std::string>& kinds, const Way& way) {
  const CaptureRoom room;
  const Scene bay = empty_bay(seed);
  SimulatedCamera before(bay, sensor, mix(seed, 1), ColorFrames::none);
  Captures initial;
  initial.push_back(captured(before, way.frames, room.path() / "before"));
  Collected collected;
  for (int litter = 0; litter < way.litters; ++litter) {
    const std::uint64_t own = litter == 0 ? seed : mix(seed, litter);
    SimulatedCamera after(littered(bay, own, kinds, way.objects), sensor, mix(own, 2), ColorFrames::first);
    Captures final;
    final.push_back(captured(after, way.frames, room.path() / fmt::format("after-{}", litter)));
    collect(compare(initial, final, way), *final.front(), visible_targets(after), seed, collected);
  }
  return collected;
}

// The files of a run. The list is written last, so that it never states planes that are missing.
class Output {
 public:
  Output(fs::path folder, Json run) : folder_(std::move(folder)), run_(std::move(run)) {
    fs::create_directories(folder_);
    if (!fs::exists(folder_ / "findings.json")) return;
    Json earlier = Json::parse(read_text_file(folder_ / "findings.json"));
    Json same = earlier["run"];
    same["inspections"] = run_["inspections"];
    if (same != run_) throw std::runtime_error(folder_.string() + " has findings of another run");
    inspections_ = earlier["inspections"];
    findings_ = earlier["findings"];
    fs::resize_file(folder_ / "planes.f16", findings_.size() * bytes_each);
  }

  [[nodiscard]] int inspections() const { return inspections_; }

  void add(const Collected& collected) {
    std::ofstream planes(folder_ / "planes.f16", std::ios::binary | std::ios::app);
    for (const cv::Mat& one : collected.planes) {
      cv::Mat half;
      one.convertTo(half, CV_16F);
      planes.write(reinterpret_cast<const char*>(half.data), static_cast<std::streamsize>(bytes_each));
    }
    planes.close();
    if (!planes) throw std::runtime_error("cannot write to " + folder_.string());
    for (const Json& finding : collected.findings) findings_.push_back(finding);
    ++inspections_;
    replace_file(folder_ / "findings.json",
                 json_file_text({{"run", run_}, {"inspections", inspections_}, {"findings", findings_}}, -1));
  }

 private:
  static constexpr std::size_t bytes_each = sizeof(std::uint16_t) * finding_planes * plane_px * plane_px;
  fs::path folder_;
  Json run_;
  int inspections_ = 0;
  Json findings_ = Json::array();
};

void simulate(const fs::path& folder, std::uint64_t first_seed, int inspections, const std::string& camera,
              const std::string& kinds, const Way& way) {
  const auto sensor_of = camera_of_each(camera);
  const std::vector<std::string> names = kinds_named(kinds);
  Output out(folder, {{"first_seed", first_seed},
                      {"inspections", inspections},
                      {"camera", camera},
                      {"kinds", kinds},
                      {"way", way.name},
                      {"planes", finding_planes},
                      {"plane_px", plane_px}});
  for (int i = out.inspections(); i < inspections; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    const Collected collected = inspect(seed, sensor_of(seed), names, way);
    out.add(collected);
    fmt::print("{}: {} findings\n", seed, collected.planes.size() / 2);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  try {
    if (arguments.count() == 6) {
      simulate(arguments.at(0), std::stoull(arguments.at(1)), std::stoi(arguments.at(2)), arguments.at(3),
               arguments.at(4), way_named(arguments.at(5)));
      return 0;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_simulated_findings: {}\n", error.what());
    return 2;
  }
  fmt::print(stderr, "usage: rva_simulated_findings OUT FIRST_SEED INSPECTIONS CAMERA KINDS WAY\n");
  return 2;
}
