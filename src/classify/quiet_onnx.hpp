// ONNX models in OpenCV, without what it prints.
#pragma once

#include <cstddef>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <span>
#include <string>

namespace rva {

/// Silences OpenCV while it exists: OpenCV also prints what it throws.
class QuietOpenCv {
 public:
  QuietOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(before_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

/// Reads a network.
/// @param name of the model, for errors
/// @throws Error when the bytes are no ONNX model, or one with operations that OpenCV lacks
[[nodiscard]] cv::dnn::Net onnx_net(std::span<const std::byte> model, const std::string& name);

}  // namespace rva
