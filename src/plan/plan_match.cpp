#include "plan/plan_match.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "core/units.hpp"
#include "plan/part_assignment.hpp"
#include "plan/part_fit.hpp"
#include "plan/pieces.hpp"

namespace rva {
namespace {

/// What became of a piece.
struct PieceState {
  PlannedState state = PlannedState::unplanned;
  std::optional<std::size_t> item;  ///< empty if it is unplanned
};

class Match {
 public:
  Match(const Plan& plan, const Detection& detection, const ComparedCameras& cameras,
        const PlanOptions& options)
      : plan_(plan),
        detection_(detection),
        options_(options),
        baseline_(detection, cameras),
        items_(in_picture(plan, cameras.initial)),
        pieces_(pieces_of(detection, baseline_)) {
    for (const Piece& piece : pieces_) {
      Fits& fits = fits_.emplace_back();
      for (const PictureItem& item : items_) fits.push_back(fit_of(piece, item, cameras.initial.fx, options));
    }
    parts_ = assign_parts(items_, pieces_, fits_);
  }

  PlanMatch run() {
    name_states();
    PlanMatch match;
    for (std::size_t item = 0; item < items_.size(); ++item) match.groups.push_back(group_of(item));
    for (std::size_t k = 0; k < findings().size(); ++k) match.findings.push_back(state_of(k));
    for (const PlannedFinding& finding : match.findings) {
      if (finding.state != PlannedState::planned) continue;
      const auto group = std::ranges::find(match.groups, *finding.item, &PlannedGroup::name);
      group->findings.push_back(finding.id);
    }
    for (PlannedGroup& group : match.groups) std::ranges::sort(group.findings);
    list_loose_pieces(match);
    std::ranges::stable_sort(match.findings, {}, &PlannedFinding::state);
    return match;
  }

 private:
  [[nodiscard]] const std::vector<Finding>& findings() const { return detection_.findings.findings; }

  void name_states() {
    states_.resize(pieces_.size());
    for (const Part& part : parts_) {
      if (!part.piece) continue;
      const bool too_large = fits_[*part.piece][part.item]->too_large;
      states_[*part.piece] = {too_large ? PlannedState::surplus : PlannedState::planned, part.item};
    }
    const std::vector<std::optional<std::size_t>> hosts = hosts_of_fragments();
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (states_[k].item) continue;
      if (hosts[k])
        states_[k] = {PlannedState::planned, states_[*hosts[k]].item};
      else if (const auto fit =
                   std::ranges::find_if(fits_[k], [](const auto& one) { return one && !one->too_small; });
               fit != fits_[k].end())
        states_[k] = {PlannedState::surplus, static_cast<std::size_t>(fit - fits_[k].begin())};
    }
  }

  // The assigned piece that each piece without a part belongs to, if there is one: the one at its place if
  // its centre is within that part; beside it or at its place one more than twice as large; a window away, or
  // in the same finding, one more than four times as large.
  [[nodiscard]] std::vector<std::optional<std::size_t>> hosts_of_fragments() const {
    constexpr int window_px = 9;  // of a matcher
    Image<int> owner(detection_.final_m.width(), detection_.final_m.height(), -1);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (!is_planned(k)) continue;
      for (const std::uint32_t i : pieces_[k].pixels) owner[i] = static_cast<int>(k);
    }
    std::vector<std::optional<std::size_t>> hosts(pieces_.size());
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (states_[k].item) continue;
      hosts[k] = part_around(k);
      std::vector<std::size_t> beside = neighbours(pieces_[k], owner, window_px / 2);
      std::ranges::copy(at_its_places(k), std::back_inserter(beside));
      if (!hosts[k]) hosts[k] = larger_one(k, 2, beside);
      std::vector<std::size_t> near = neighbours(pieces_[k], owner, window_px);
      std::ranges::copy(of_same_finding(k), std::back_inserter(near));
      if (!hosts[k]) hosts[k] = larger_one(k, 4, near);
    }
    return hosts;
  }

  // The piece of the part within which the piece has its centre: no second object can have its own there.
  [[nodiscard]] std::optional<std::size_t> part_around(std::size_t piece) const {
    for (const Part& part : parts_) {
      const std::optional<PartFit>& fit = fits_[piece][part.item];
      const std::optional<RangeMm>& size_mm = plan_.items[part.item].size_mm;
      if (!part.piece || !part.place || !fit || !size_mm || fit->too_large || !is_planned(*part.piece))
        continue;
      const auto at = std::ranges::find(fit->places, *part.place, &PlaceFit::place);
      if (at != fit->places.end() && at->distance_mm <= size_mm->low / 2) return part.piece;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_planned(std::size_t piece) const {
    return states_[piece].state == PlannedState::planned;
  }

  // The first of the hosts that is more than `times` as large as the piece.
  [[nodiscard]] std::optional<std::size_t> larger_one(std::size_t piece, std::size_t times,
                                                      const std::vector<std::size_t>& hosts) const {
    const auto host = std::ranges::find_if(hosts, [&](std::size_t k) {
      return times * pieces_[piece].pixels.size() < pieces_[k].pixels.size();
    });
    return host == hosts.end() ? std::nullopt : std::optional(*host);
  }

  [[nodiscard]] std::vector<std::size_t> of_same_finding(std::size_t piece) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (is_planned(k) && pieces_[k].finding == pieces_[piece].finding) found.push_back(k);
    }
    return found;
  }

  [[nodiscard]] std::vector<std::size_t> at_its_places(std::size_t piece) const {
    std::vector<std::size_t> found;
    for (const Part& part : parts_) {
      const std::optional<PartFit>& fit = fits_[piece][part.item];
      if (!part.piece || !part.place || !fit || !is_planned(*part.piece)) continue;
      if (std::ranges::find(fit->places, *part.place, &PlaceFit::place) != fit->places.end())
        found.push_back(*part.piece);
    }
    return found;
  }

  [[nodiscard]] static std::vector<std::size_t> neighbours(const Piece& piece, const Image<int>& owner,
                                                           int within_px) {
    std::vector<std::size_t> found;
    const Box& box = piece.box;
    const int right = std::min(owner.width(), box.x + box.width + within_px);
    const int bottom = std::min(owner.height(), box.y + box.height + within_px);
    for (int v = std::max(0, box.y - within_px); v < bottom; ++v) {
      for (int u = std::max(0, box.x - within_px); u < right; ++u) {
        if (owner(u, v) >= 0) found.push_back(static_cast<std::size_t>(owner(u, v)));
      }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  [[nodiscard]] PlannedGroup group_of(std::size_t item) const {
    const PlannedItem& planned = plan_.items[item];
    PlannedGroup group;
    group.name = planned.name;
    group.kind = planned.kind;
    group.planned = planned.count;
    for (const Part& part : parts_) {
      if (part.item != item) continue;
      if (part.piece) {
        ++group.found;
        continue;
      }
      AbsentPart absent;
      if (part.place) {
        absent.place = static_cast<int>(*part.place) + 1;
        absent.pixel = items_[item].places[*part.place];
      }
      (was_inspected(item, part.place) ? group.missing : group.not_inspected).push_back(absent);
    }
    return group;
  }

  // Whether the least of the parts would have been found.
  [[nodiscard]] bool would_be_found(std::optional<double> level_mm, const PlannedItem& item) const {
    return level_mm && (item.kind == ChangeKind::appearance || *level_mm <= item.height_mm.low);
  }

  [[nodiscard]] bool was_inspected(std::size_t item, std::optional<std::size_t> place) const {
    const PlannedItem& planned = plan_.items[item];
    if (!place) return share_inspected(items_[item]) >= options_.inspected;
    const Eigen::Vector2d& pixel = items_[item].places[*place];
    if (!baseline_.camera().contains(pixel) || is_hidden(planned, *place, pixel)) return false;
    return would_be_found(baseline_.level_mm(pixel), planned);
  }

  // Whether something stands in front of a place whose depth is known.
  [[nodiscard]] bool is_hidden(const PlannedItem& item, std::size_t place,
                               const Eigen::Vector2d& pixel) const {
    const double place_m = item.places[place].depth_m;
    const double seen_m = baseline_.depth_m()(static_cast<int>(std::lround(pixel.x())),
                                              static_cast<int>(std::lround(pixel.y())));
    if (place_m <= 0.0 || seen_m <= 0.0) return false;
    const double margin_mm = item.height_mm.high + item.tolerance_mm + options_.height_error_mm;
    return mm_per_m * (place_m - seen_m) > margin_mm;
  }

  [[nodiscard]] double share_inspected(const PictureItem& item) const {
    const Image<float>& least_mm = baseline_.least_mm();
    const Mask area = mask_of({.ignore = item.areas, .within = {}}, least_mm.width(), least_mm.height());
    std::size_t pixels = 0;
    std::size_t inspected = 0;
    for (std::size_t i = 0; i < area.size(); ++i) {
      if (area[i] == 0) continue;
      ++pixels;
      const bool judged = !std::isnan(least_mm[i]);
      inspected +=
          judged && would_be_found(static_cast<double>(least_mm[i]), *item.item) ? std::size_t{1} : 0;
    }
    return pixels == 0 ? 0.0 : static_cast<double>(inspected) / static_cast<double>(pixels);
  }

  // A finding is what its most remarkable piece is.
  [[nodiscard]] PlannedFinding state_of(std::size_t finding) const {
    PieceState least{PlannedState::planned, std::nullopt};
    std::map<std::size_t, int> pieces_of_item;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (pieces_[k].finding != finding) continue;
      if (states_[k].state < least.state) least = states_[k];
      if (states_[k].item) ++pieces_of_item[*states_[k].item];
    }
    if (least.state == PlannedState::planned)
      least.item =
          std::ranges::max_element(pieces_of_item, {}, [](const auto& item) { return item.second; })->first;
    PlannedFinding named{.id = findings()[finding].id, .state = least.state, .item = {}};
    if (least.item) named.item = plan_.items[*least.item].name;
    return named;
  }

  void list_loose_pieces(PlanMatch& match) const {
    std::vector<std::size_t> order(pieces_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return findings()[pieces_[k].finding].id; });
    for (const std::size_t k : order) {
      if (states_[k].state == PlannedState::planned) continue;
      const Piece& piece = pieces_[k];
      LoosePiece loose{.finding = findings()[piece.finding].id,
                       .box = piece.box,
                       .area_px = piece.pixels.size(),
                       .height_mm = piece.kind == ChangeKind::appearance ? std::nullopt : piece.height_mm,
                       .item = {}};
      if (states_[k].item) loose.item = plan_.items[*states_[k].item].name;
      (loose.item ? match.surplus : match.unplanned).push_back(loose);
    }
  }

  const Plan& plan_;
  const Detection& detection_;
  const PlanOptions& options_;
  BaselineView baseline_;
  std::vector<PictureItem> items_;
  std::vector<Piece> pieces_;  // in an order that depends on their pixels alone
  std::vector<Fits> fits_;     // for each piece
  std::vector<Part> parts_;
  std::vector<PieceState> states_;  // for each piece
};

}  // namespace

PlanMatch match_plan(const Plan& plan, const Detection& detection, const ComparedCameras& cameras,
                     const PlanOptions& options) {
  check_options(options);
  return Match(plan, detection, cameras, options).run();
}

}  // namespace rva
