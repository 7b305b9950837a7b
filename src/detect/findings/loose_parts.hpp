// Loose parts of a shake test: pairs of findings that one part left by moving.
#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "detect/findings/detection.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Options of find_loose_parts().
struct LoosePartOptions {
  double reach_mm = 50.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.reach_mm,
          OptionField{"loose-reach", "mm", 1, 1000, "--shake: farthest that a loose part may have moved"});
  }
};

/// A part that moved between the captures.
struct LoosePart {
  int added = 0;    ///< id of the finding where the part is now
  int removed = 0;  ///< id of the finding where it was
  /// From the middle of the removed finding to that of the added one, to the right and down in the image,
  /// millimetres at the distance of the part. A part that moved by less than its own width leaves two
  /// crescents, whose middles are farther apart than it moved.
  Eigen::Vector2d apart_mm{0, 0};
  std::array<double, 2> size_mm{0, 0};  ///< width and height in the image of both findings together

  /// The part moved by at most this across the view, millimetres.
  [[nodiscard]] double moved_at_most_mm() const { return apart_mm.norm(); }
};

/// Pairs added with removed findings that one part may have left by moving (docs/shake-test.md): they are no
/// farther apart than `reach_mm`, and their areas and heights are alike. The nearest are paired first, each
/// finding once at most. No finding is removed.
///
/// If initial and final captures are exchanged, the same parts are found, with the opposite motion.
/// @param camera of the first final capture
/// @throws UsageError for options out of range
[[nodiscard]] std::vector<LoosePart> find_loose_parts(const Detection& detection, const Intrinsics& camera,
                                                      const LoosePartOptions& options);

/// Where a part moved in the image, in words: "to the left and down".
[[nodiscard]] std::string direction_of(const LoosePart& part);

/// Adds `loose_parts` to the content of `detections.json`, and `loose_part` to their findings
/// (docs/shake-test.md).
void add_loose_parts(const std::vector<LoosePart>& parts, nlohmann::ordered_json& detections);

}  // namespace rva
