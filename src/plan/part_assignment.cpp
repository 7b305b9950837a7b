#include "plan/part_assignment.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantile.hpp"
#include "plan/assignment.hpp"

namespace rva {
namespace {

// Any part that is found outweighs all distances and second parts of a piece.
constexpr double found_cost = -1000.0;
constexpr double second_cost = 10.0;
constexpr double small_cost = 5.0;
constexpr double area_cost = 1.0;
constexpr double largest_distance = 3.0;  // in tolerances
constexpr double impossible_cost = 1e6;

/// A piece as one part; a piece that may be several parts has a candidate for each.
struct Candidate {
  std::size_t piece = 0;
  bool first = true;
};

std::vector<Part> parts_of(const std::vector<PictureItem>& items) {
  std::vector<Part> parts;
  for (std::size_t item = 0; item < items.size(); ++item) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(items[item].item->count); ++k)
      parts.push_back({item, items[item].places.empty() ? std::nullopt : std::optional(k), std::nullopt});
  }
  return parts;
}

// The median number of pixels of the pieces that are one part of the item.
double usual_area_px(std::size_t item, const std::vector<Piece>& pieces, const std::vector<Fits>& fits) {
  std::vector<double> areas_px;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (const auto& fit = fits[k][item]; fit && !fit->several && !fit->too_small)
      areas_px.push_back(static_cast<double>(pieces[k].pixels.size()));
  }
  return areas_px.empty() ? 0.0 : quantile(areas_px, 0.5);
}

// How many parts a piece may be: as many as the places that it covers, or as its area has room for.
std::size_t most_parts(std::size_t piece, const std::vector<double>& usual_px,
                       const std::vector<Piece>& pieces, const std::vector<Fits>& fits) {
  std::size_t most = 1;
  for (std::size_t item = 0; item < usual_px.size(); ++item) {
    const std::optional<PartFit>& fit = fits[piece][item];
    if (!fit) continue;
    most = std::max(most, fit->places.size());
    if (fit->several && fit->places.empty() && usual_px[item] > 0.0)
      most = std::max(most, static_cast<std::size_t>(std::lround(
                                static_cast<double>(pieces[piece].pixels.size()) / usual_px[item])));
  }
  return most;
}

// A piece that is too small for a part is one only at a place that no other piece fills.
double cost_of(const PartFit& fit, const Part& part, const PlannedItem& item) {
  if (!part.place) return fit.too_small ? impossible_cost : found_cost + area_cost + fit.misfit;
  const auto at = std::ranges::find(fit.places, *part.place, &PlaceFit::place);
  if (at == fit.places.end()) return impossible_cost;
  const double small = fit.too_small ? small_cost : 0.0;
  return found_cost + std::min(at->distance_mm / item.tolerance_mm, largest_distance) + small;
}

std::vector<Candidate> candidates_of(std::size_t items, const std::vector<Piece>& pieces,
                                     const std::vector<Fits>& fits, std::size_t parts) {
  std::vector<double> usual_px;
  for (std::size_t item = 0; item < items; ++item) usual_px.push_back(usual_area_px(item, pieces, fits));
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (std::ranges::none_of(fits[k], [](const auto& fit) { return fit.has_value(); })) continue;
    const std::size_t most = std::min(most_parts(k, usual_px, pieces, fits), parts);
    for (std::size_t copy = 0; copy < most; ++copy) candidates.push_back({k, copy == 0});
  }
  return candidates;
}

}  // namespace

std::vector<Part> assign_parts(const std::vector<PictureItem>& items, const std::vector<Piece>& pieces,
                               const std::vector<Fits>& fits) {
  std::vector<Part> parts = parts_of(items);
  const std::vector<Candidate> candidates = candidates_of(items.size(), pieces, fits, parts.size());
  // The columns after those of the parts are for candidates that are no part.
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(candidates.size()),
                                                static_cast<Eigen::Index>(parts.size() + candidates.size()));
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    for (std::size_t column = 0; column < parts.size(); ++column) {
      const Part& part = parts[column];
      const std::optional<PartFit>& fit = fits[candidates[row].piece][part.item];
      const double cost = fit ? cost_of(*fit, part, *items[part.item].item) : impossible_cost;
      costs(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          candidates[row].first ? cost : cost + second_cost;
    }
  }
  const std::vector<int> assigned = least_cost_assignment(costs);
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    const auto column = static_cast<std::size_t>(assigned[row]);
    if (column < parts.size()) parts[column].piece = candidates[row].piece;
  }
  return parts;
}

}  // namespace rva
