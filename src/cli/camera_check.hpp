// `rva noise --camera`: a camera against its own history.
#pragma once

#include <string>

#include "camera/camera.hpp"
#include "camera/check_standard.hpp"

namespace rva::cli {

/// The arguments of `rva noise --camera` that compare a camera with its history.
struct CameraCheckArguments {
  std::size_t frames = 60;       ///< frames to measure
  std::string history;           ///< folder; empty: the user's own
  CheckStandardOptions options;  ///< of the judgement
  bool json = false;             ///< print the judgement as JSON
};

/// Measures, judges, prints, and adds the check to the history.
/// @return whether the camera is fit; true also if there are too few earlier checks to judge it
/// @throws Error
[[nodiscard]] bool check_before_work(Camera& camera, const CameraCheckArguments& arguments);

}  // namespace rva::cli
