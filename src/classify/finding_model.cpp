#include "classify/finding_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <set>
#include <string_view>

#include "audit/digest.hpp"
#include "classify/finding_planes.hpp"
#include "classify/quiet_onnx.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

// shipped_model.S
extern "C" {
extern const char rva_shipped_model[];
extern const char rva_shipped_model_end[];
extern const char rva_shipped_card[];
extern const char rva_shipped_card_end[];
}

namespace rva {
namespace {

constexpr std::string_view format_name = "rva-finding-model";
constexpr int version = 1;

void require(bool holds, const JsonObject& card, std::string_view key, const std::string& what) {
  if (!holds) throw Error(card.name_of(key), what, "use a card that training/train.py wrote");
}

std::vector<std::string> labels_of(const nlohmann::json& json, const JsonObject& card) {
  const auto labels = json.find("labels");
  require(labels != json.end() && labels->is_array() && !labels->empty() &&
              std::ranges::all_of(*labels, [](const auto& label) { return label.is_string(); }),
          card, "labels", "is not a list of names");
  auto names = labels->get<std::vector<std::string>>();
  require(std::set<std::string>(names.begin(), names.end()).size() == names.size(), card, "labels",
          "has a name twice");
  return names;
}

double share(const JsonObject& card, const char* key, double least, double most) {
  const double value = card.number(key);
  require(value >= least && value <= most, card, key, fmt::format("is not from {} to {}", least, most));
  return value;
}

// The softmax of the outputs at a temperature.
std::vector<double> probabilities(const cv::Mat& outputs, double temperature) {
  const auto* const first = outputs.ptr<float>();
  const std::vector<float> values(first, first + outputs.total());
  const double greatest = *std::ranges::max_element(values);
  std::vector<double> shares;
  double sum = 0.0;
  for (const float value : values) sum += shares.emplace_back(std::exp((value - greatest) / temperature));
  for (double& one : shares) one /= sum;
  return shares;
}

}  // namespace

FindingModel FindingModel::shipped() {
  const std::string_view card(rva_shipped_card, rva_shipped_card_end);
  const std::span model(rva_shipped_model, rva_shipped_model_end);
  return {std::string(card), "findings.json", std::as_bytes(model)};
}

FindingModel FindingModel::read(const std::filesystem::path& card) {
  const std::string text = read_text_file(card);
  const std::string source = printable(card);
  const nlohmann::json json = parse_json(text, source);
  const JsonObject object(json, source);
  const std::filesystem::path name = object.string("model");
  require(!name.empty() && name == name.filename() && name != "." && name != "..", object, "model",
          "is not the name of a file beside the card");
  return {text, source, read_file(card.parent_path() / name)};
}

FindingModel::FindingModel(const std::string& card_text, const std::string& card_name,
                           std::span<const std::byte> model) {
  const nlohmann::json json = parse_json(card_text, card_name);
  const JsonObject card(json, card_name);
  require(card.string("format") == format_name, card, "format", fmt::format("is not {}", format_name));
  require(card.integer("version") == version, card, "version",
          fmt::format("is not {}: the card was written by another version", version));
  require(card.integer("planes") == finding_planes && card.integer("plane_px") == plane_px, card, "planes",
          fmt::format("are not {} of {} pixels", finding_planes, plane_px));
  labels_ = labels_of(json, card);
  name_ = card.string("model");
  temperature_ = share(card, "temperature", 0.01, 100.0);
  least_probability_ = share(card, "least_probability", 0.0, 1.0);
  sha256_ = hex_of(bytes_of(rva::sha256({reinterpret_cast<const char*>(model.data()), model.size()})));
  require(card.string("sha256") == sha256_, card, "sha256", fmt::format("is not that of {}", name_));
  net_ = onnx_net(model, name_);
}

LikelyClass FindingModel::classify(const cv::Mat& planes) {
  const std::vector<int> batch{1, finding_planes, plane_px, plane_px};
  cv::Mat outputs;
  try {
    const QuietOpenCv quiet;
    net_.setInput(planes.reshape(1, batch));
    outputs = net_.forward();
  } catch (const cv::Exception&) {
    throw Error(name_, fmt::format("does not take {} planes of {} pixels", finding_planes, plane_px),
                "use a model that training/train.py wrote");
  }
  if (outputs.total() != labels_.size() + 1 || outputs.type() != CV_32F)
    throw Error(name_,
                fmt::format("has {} outputs, {} labels need one more", outputs.total(), labels_.size()),
                "use a model that training/train.py wrote");
  if (!cv::checkRange(outputs))
    throw Error(name_, "states probabilities that are no numbers",
                "use a model that training/train.py wrote");
  const std::vector<double> all = probabilities(outputs, temperature_);
  const auto best = std::max_element(all.begin(), all.end() - 1);
  // The last digits depend on the processor; results should not.
  constexpr double steps = 1000.0;
  const double probability = std::round(steps * *best) / steps;
  return {static_cast<std::size_t>(best - all.begin()), probability, probability < least_probability_};
}

}  // namespace rva
