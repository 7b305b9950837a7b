// Whether a piece of a finding may be a planned part.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "detect/regions/ignored_regions.hpp"
#include "plan/pieces.hpp"
#include "plan/plan_match.hpp"

namespace rva {

/// An item of a plan in the baseline's picture.
struct PictureItem {
  const PlannedItem* item = nullptr;    ///< never null
  std::vector<Polygon> areas;           ///< in pixels
  std::vector<Eigen::Vector2d> places;  ///< in pixels
  std::optional<double> depth_m;        ///< mean of its points, if the plan states depths
};

/// The items of a plan in the picture of this camera, in their order. The plan must outlive them.
[[nodiscard]] std::vector<PictureItem> in_picture(const Plan& plan, const Intrinsics& camera);

/// A planned place whose tolerance includes a piece.
struct PlaceFit {
  std::size_t place = 0;     ///< index in the item's places
  double distance_mm = 0.0;  ///< from the piece's centre, across the view
};

/// How a piece fits an item in whose areas or at whose places it is.
struct PartFit {
  std::vector<PlaceFit> places;  ///< those that it may be at; empty away from all
  /// By how much its height is off the range: 0 not at all, 1 just within the uncertainty.
  double misfit = 0.0;
  bool too_small = false;  ///< less than half as large as a part: one at a place, or a piece of one
  bool too_large = false;  ///< larger than one part, in every direction or beyond its places
  bool several = false;    ///< longer than one part, but not wider: it may be several parts of an area
};

/// @param focal_px focal length of the baseline's camera
/// @return empty where the piece can be no part of the item
[[nodiscard]] std::optional<PartFit> fit_of(const Piece& piece, const PictureItem& item, double focal_px,
                                            const PlanOptions& options);

}  // namespace rva
