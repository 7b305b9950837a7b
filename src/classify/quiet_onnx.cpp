#include "classify/quiet_onnx.hpp"

#include "core/error.hpp"

namespace rva {

cv::dnn::Net onnx_net(std::span<const std::byte> model, const std::string& name) {
  const QuietOpenCv quiet;
  try {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(reinterpret_cast<const char*>(model.data()), model.size());
    if (!net.empty()) return net;
  } catch (const cv::Exception&) {
    // The message names functions of OpenCV. The error below states the same for a user.
  }
  throw Error(name, "is no ONNX model, or one with operations that OpenCV does not have",
              "export the model as ONNX with opset 12 or earlier, without postprocessing");
}

}  // namespace rva
