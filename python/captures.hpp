// Captures as Python has them, and as functions take them.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "keywords.hpp"

namespace rva::python {

/// The class Capture.
struct OpenCapture {
  std::filesystem::path path;  ///< as it was given
  std::unique_ptr<const Capture> capture;
};

/// The arguments of every function that opens captures.
struct CaptureArguments {
  std::optional<std::array<double, 4>> intrinsics{};  ///< fx, fy, cx, cy, px
  std::vector<std::uint16_t> no_depth{};
  std::optional<double> depth_unit_mm{};
  std::optional<std::string> topic{};

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("intrinsics", self.intrinsics,
          "fx, fy, cx and cy of a depth camera whose captures state none (TUM, images alone, ROS without "
          "camera_info)");
    visit("no_depth", self.no_depth, "values of depth that mean no measurement, besides 0 and 65535");
    visit("depth_unit", self.depth_unit_mm,
          "one step of the depth images in mm, whatever the capture states");
    visit("topic", self.topic,
          "the topic of the depth images in a recording of ROS, where there are several");
  }

  /// The options for open_capture(). @throws OptionError when no camera can have them
  [[nodiscard]] CaptureOptions options() const;
};

/// Captures that a call was given, of one side.
struct CaptureSide {
  std::vector<std::shared_ptr<const OpenCapture>> owners;

  /// The captures, which the owners must outlive.
  [[nodiscard]] Captures captures() const;
  /// Their paths as they were given.
  [[nodiscard]] std::vector<std::filesystem::path> paths() const;
};

/// Takes a capture or a path, which is opened.
/// @throws TypeError of Python for anything else; Error as open_capture(); UsageError when arguments are
///         given that a capture that is already open cannot heed
[[nodiscard]] std::shared_ptr<const OpenCapture> capture_from(pybind11::handle object,
                                                              const CaptureArguments& arguments);

/// Takes one or several of what capture_from() takes. @throws UsageError when there is none
[[nodiscard]] CaptureSide side_from(pybind11::handle object, const CaptureArguments& arguments,
                                    const char* side);

}  // namespace rva::python
