// Depth values that mean "no measurement" in files of other tools.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// The depth values that mean no measurement. 0 and 65535 always do. Others are stated by the capture's
/// description or by the user, or are recognised in the first frame: the largest value of the image, if it is
/// a usual one such as 10000 or 4095, corresponds to 4 m or more, occurs in many pixels, and is far beyond
/// all others.
///
/// Reading is const and may run on several threads.
class NoDepthValues {
 public:
  /// @param stated values besides 0 and 65535
  /// @param unit_m depth of one step of the depth images, metres
  NoDepthValues(std::vector<std::uint16_t> stated, double unit_m);

  /// Sets pixels without a measurement to no_depth.
  /// @param first_frame gives the frame in which values are recognised. It is called once, on the first use
  ///                    of any of these functions; what it throws is passed on
  void clear(DepthImage& frame, const std::function<DepthImage()>& first_frame) const;

  /// False when the first frame has other values that mean no measurement, and no 0.
  /// @param first_frame as for clear()
  [[nodiscard]] bool are_zero(const std::function<DepthImage()>& first_frame) const;

  /// The values that were found in the first frame and how often: one sentence each, without a full stop.
  /// @param first_frame as for clear()
  [[nodiscard]] std::vector<std::string> notes(const std::function<DepthImage()>& first_frame) const;

 private:
  void learn(const std::function<DepthImage()>& first_frame) const;

  double unit_m_;
  mutable std::once_flag learnt_;
  mutable std::vector<std::uint16_t> values_;  // besides 0
  mutable std::vector<std::string> notes_;
  mutable bool are_zero_ = true;
};

/// Converts depth in metres to whole units, rounded. NaN, infinity, values that round to less than one unit,
/// and values that do not fit into 16 bits become no_depth.
[[nodiscard]] DepthImage depth_from_metres(const Image<float>& depth_m, double unit_m);

}  // namespace rva
