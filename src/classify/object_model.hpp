// A trained object detector from an ONNX file, which users bring.
#pragma once

#include <filesystem>
#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

#include "classify/model_outputs.hpp"
#include "core/options.hpp"
#include "depth/image.hpp"

namespace rva {

/// Objects that a model reports with a smaller probability are left out: most models report thousands of
/// them.
inline constexpr double least_object_probability = 0.05;

/// What pictures a model takes, and from when its classes count.
struct ModelOptions {
  int model_width = 640;         ///< pixels of the model's picture
  int model_height = 640;        ///< pixels of the model's picture
  double model_mean = 0.0;       ///< the model's numbers are (value - mean) / scale, of values 0 to 255
  double model_scale = 255.0;    ///< see model_mean
  double class_certainty = 0.5;  ///< findings with a less probable class are of class unknown

  static void describe(auto&& self, auto&& visit) {
    visit(self.model_width,
          OptionField{"model-width", "px", 8, 4096, "with a model: width of the pictures that it takes"});
    visit(self.model_height,
          OptionField{"model-height", "px", 8, 4096, "with a model: height of the pictures that it takes"});
    visit(self.model_mean,
          OptionField{"model-mean", "", 0, 255,
                      "with a model: what is subtracted from red, green and blue of 0 to 255"});
    visit(self.model_scale,
          OptionField{"model-scale", "", 0.001, 1000, "with a model: what they are then divided by"});
    visit(self.class_certainty,
          OptionField{"class-certainty", "", 0, 1,
                      "with a model: findings whose class is less probable are of class unknown"});
  }
};

/// A YOLO or SSD detector (model_outputs.hpp).
class ObjectModel {
 public:
  /// @param file   ONNX, of a version that OpenCV 4.6 reads: exported with opset 12 or earlier, as a rule
  /// @param labels the names of its classes (read_labels())
  /// @throws UsageError for options out of range; Error when the file cannot be read or is no such model
  ObjectModel(const std::filesystem::path& file, std::vector<std::string> labels,
              const ModelOptions& options);

  /// The objects that the model reports in a picture with at least least_object_probability, the most
  /// probable first.
  /// @param picture of any size, at least 1 x 1; fitted into the model's picture with its proportions, with
  ///                grey beside it
  /// @throws Error when the model does not take pictures of the size stated, or its outputs do not fit
  [[nodiscard]] std::vector<ModelObject> objects_in(const ColorImage& picture);

  /// The name of a class, by its number from 0.
  [[nodiscard]] const std::string& label(int number) const {
    return labels_.at(static_cast<std::size_t>(number));
  }
  /// Number of classes.
  [[nodiscard]] int classes() const { return static_cast<int>(labels_.size()); }
  /// The options that it was made with.
  [[nodiscard]] const ModelOptions& options() const { return options_; }
  /// The file that it was read from.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  std::vector<std::string> labels_;
  ModelOptions options_;
  cv::dnn::Net net_;
};

}  // namespace rva
