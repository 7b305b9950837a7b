// Options of measuring in depth images.
#pragma once

#include "core/options.hpp"

namespace rva {

/// What is assumed of the errors of a measurement (section 13 of docs/math.md).
struct MeasureOptions {
  double matching_px = 0.1;          ///< fixed error of a match, standard deviation in px of disparity
  double frame_px = 0.03;            ///< deviation over time where only one frame was taken, px of disparity
  double correlation_px = 11.0;      ///< pixels farther apart than this along u or v have independent errors
  double pointing_px = 0.5;          ///< standard uncertainty of a tapped pixel along u and along v
  double calibration_share = 0.005;  ///< standard uncertainty of the camera's scale, as a share of a length

  static void describe(auto&& self, auto&& visit) {
    visit(self.matching_px, OptionField{"matching-error", "px", 0, 5,
                                        "standard deviation of disparity that more frames do not reduce"});
    visit(self.frame_px, OptionField{"frame-error", "px", 0, 5,
                                     "standard deviation of disparity over time where one frame was taken"});
    visit(self.correlation_px,
          OptionField{"matcher-window", "px", 1, 100,
                      "width of the window of the camera's matcher, within which errors are similar"});
    visit(self.pointing_px,
          OptionField{"pointing-error", "px", 0, 20, "standard uncertainty of a tapped pixel"});
    visit(self.calibration_share,
          OptionField{"calibration-error", "", 0, 0.2,
                      "standard uncertainty of the camera's scale, as a share of what is measured"});
  }
};

}  // namespace rva
