// Live pictures that stand still while people look at them, and measure in them.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "depth/image.hpp"
#include "measure/measured_picture.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// A live picture that was frozen.
struct FrozenPicture {
  Stream stream = Stream::color;
  ColorImage picture;
  std::optional<MeasuredPicture> measured;  ///< empty where nothing can be measured (is_measurable())
  std::size_t frames = 0;                   ///< number of depth images that `measured` is of
  std::string taken_at;                     ///< ISO 8601
};

/// The pictures that were frozen last, in memory only. Every member may be called from any thread.
class FrozenPictures {
 public:
  /// Older ones are dropped.
  static constexpr std::size_t most = 8;

  /// @return its number, from 1, which no other one gets while the program runs
  [[nodiscard]] int add(FrozenPicture picture);
  /// Null where there is none of this number, or it was dropped.
  [[nodiscard]] std::shared_ptr<const FrozenPicture> find(int number) const;

 private:
  mutable std::mutex mutex_;
  int last_ = 0;
  std::deque<std::shared_ptr<const FrozenPicture>> kept_;  // the newest last, with the number `last_`
};

}  // namespace rva
