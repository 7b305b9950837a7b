// Values of a depth image that stand for "no measurement", as other tools write them.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// 0 and 65535 always mean that nothing was measured. Others are stated by a capture's description or by a
/// person, or are recognised in the first frame: a value such as 10000 or 4095 that is the largest of the
/// image, at 4 m and more, in many pixels, far beyond all others.
///
/// Reading is const and may run on several threads.
class NoDepthValues {
 public:
  /// @param stated values besides 0 and 65535
  /// @param unit_m metres of one step of the depth images
  NoDepthValues(std::vector<std::uint16_t> stated, double unit_m);

  /// Sets pixels without a measurement to no_depth.
  /// @param first_frame is called once, before the first use, to recognise values in; what it throws is
  /// passed on
  void clear(DepthImage& frame, const std::function<DepthImage()>& first_frame) const;

  /// False where the first frame has other such values and no 0.
  /// @param first_frame as of clear()
  [[nodiscard]] bool are_zero(const std::function<DepthImage()>& first_frame) const;

  /// Which values were found in the first frame and how often, a sentence each without a full stop. Reads
  /// that frame, as clear() does.
  [[nodiscard]] std::vector<std::string> notes(const std::function<DepthImage()>& first_frame) const;

 private:
  void learn(const std::function<DepthImage()>& first_frame) const;

  double unit_m_;
  mutable std::once_flag learnt_;
  mutable std::vector<std::uint16_t> values_;  // besides 0
  mutable std::vector<std::string> notes_;
  mutable bool are_zero_ = true;
};

/// Depth in metres as images of 32 bit floating point hold it, in whole units. NaN, infinity, what is not
/// above 0 and what does not fit are no_depth.
[[nodiscard]] DepthImage depth_from_metres(const Image<float>& depth_m, double unit_m);

}  // namespace rva
