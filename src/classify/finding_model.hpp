// A classifier of findings: an ONNX model with a card that states its classes and how it was calibrated.
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/dnn.hpp>
#include <span>
#include <string>
#include <vector>

namespace rva {

/// What a finding may be, by a classifier.
struct LikelyClass {
  std::size_t number = 0;    ///< of the most probable label
  double probability = 0.0;  ///< of that label, calibrated, in thousandths
  bool unknown = false;      ///< whether the finding is of class unknown
};

/// A classifier of findings (finding_planes.hpp). `training/train.py` writes such models.
///
/// The model has one output for each label of its card and, last, one for everything else. Probabilities are
/// the softmax of the outputs, divided by the card's temperature (Guo et al., On Calibration of Modern Neural
/// Networks, ICML 2017).
class FindingModel {
 public:
  /// The model that comes with RVA (data/models/).
  [[nodiscard]] static FindingModel shipped();

  /// @param card JSON file that names the model beside it (docs/classification.md)
  /// @throws Error when either cannot be read, the model is no ONNX model or another one than the card
  ///         states, or takes other planes
  [[nodiscard]] static FindingModel read(const std::filesystem::path& card);

  /// The class of a finding: unknown if the most probable label is less probable than the card's
  /// `least_probability`.
  /// @param planes as planes_of() returns them
  /// @throws Error when the model does not take them, or its outputs are not finite or not one for each label
  ///         and one more
  [[nodiscard]] LikelyClass classify(const cv::Mat& planes);

  /// The names of its classes.
  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }
  /// The file name of the model.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// SHA-256 of the model, hexadecimal.
  [[nodiscard]] const std::string& sha256() const { return sha256_; }
  /// Labels that are less probable are unknown.
  [[nodiscard]] double least_probability() const { return least_probability_; }

 private:
  FindingModel(const std::string& card_text, const std::string& card_name, std::span<const std::byte> model);

  std::vector<std::string> labels_;
  std::string name_;
  std::string sha256_;
  double temperature_ = 1.0;
  double least_probability_ = 0.0;
  cv::dnn::Net net_;
};

}  // namespace rva
