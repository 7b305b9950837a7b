#include "classify/object_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "classify/quiet_onnx.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

// Where a picture lies in the model's picture.
struct Fit {
  double scale = 1.0;
  cv::Rect place;
};

Fit fitted(cv::Size picture, cv::Size model) {
  const double scale = std::min(static_cast<double>(model.width) / picture.width,
                                static_cast<double>(model.height) / picture.height);
  const cv::Size size(std::clamp(static_cast<int>(std::lround(scale * picture.width)), 1, model.width),
                      std::clamp(static_cast<int>(std::lround(scale * picture.height)), 1, model.height));
  return {scale, {{(model.width - size.width) / 2, (model.height - size.height) / 2}, size}};
}

cv::Mat model_picture(const cv::Mat& picture, cv::Size size, const Fit& fit) {
  constexpr double margin = 114.0;  // the grey with which YOLO models are trained
  cv::Mat made(size, CV_8UC3, cv::Scalar::all(margin));
  cv::Mat place = made(fit.place);
  cv::resize(picture, place, fit.place.size(), 0, 0, fit.scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return made;
}

cv::Rect2d in_picture(const cv::Rect2d& box, const Fit& fit) {
  return {(box.x - fit.place.x) / fit.scale, (box.y - fit.place.y) / fit.scale, box.width / fit.scale,
          box.height / fit.scale};
}

}  // namespace

ObjectModel::ObjectModel(const std::filesystem::path& file, std::vector<std::string> labels,
                         const ModelOptions& options)
    : file_(file), labels_(std::move(labels)), options_(options) {
  check_options(options_);
  net_ = onnx_net(read_file(file_), printable(file_));
}

std::vector<ModelObject> ObjectModel::objects_in(const ColorImage& picture) {
  const cv::Size size(options_.model_width, options_.model_height);
  const Fit fit = fitted({picture.width(), picture.height()}, size);
  const cv::Mat blob =
      cv::dnn::blobFromImage(model_picture(as_mat(picture), size, fit), 1.0 / options_.model_scale, size,
                             cv::Scalar::all(options_.model_mean));
  std::vector<cv::Mat> outputs;
  try {
    const QuietOpenCv quiet;
    net_.setInput(blob);
    net_.forward(outputs, net_.getUnconnectedOutLayersNames());
  } catch (const cv::Exception&) {
    throw Error(printable(file_),
                fmt::format("does not take a picture of {}x{} pixels", size.width, size.height),
                "state the size of picture that the model was exported for");
  }
  std::vector<ModelObject> objects =
      rva::objects_in(outputs, classes(), size, least_object_probability, printable(file_));
  for (ModelObject& object : objects) object.box = in_picture(object.box, fit);
  return objects;
}

}  // namespace rva
