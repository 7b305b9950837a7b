#include "views/registration.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "core/parallel.hpp"
#include "core/units.hpp"
#include "views/normal_equations.hpp"
#include "views/registration_starts.hpp"

namespace rva {
namespace {

constexpr int coarse_step_px = 8;
constexpr int fine_step_px = 4;
constexpr int window_px = 8;           // of a patch: about that of the matcher
constexpr double last_reach_px = 0.6;  // four deviations of the fixed-pattern noise of a matcher

// One Gauss-Newton step, slightly damped so that unconstrained directions do not move.
// Equation 37 of docs/math.md.
AlignmentStep step_of(const NormalEquations& sum, const Alignment& alignment) {
  AlignmentInformation information = sum.information;
  AlignmentStep gradient = sum.gradient;
  information(6, 6) += offset_prior;
  gradient[6] += offset_prior * alignment.offset_px;
  information.diagonal().head<6>().array() += 1e-4 * information.diagonal().head<6>().mean();
  return -information.ldlt().solve(gradient);
}

/// Schedule of a minimisation, during which the reach of the biweight shrinks geometrically.
struct Descent {
  int steps = 1;
  double first_reach_px = 1.0;
  double last_reach_px = 1.0;
  std::size_t kept = 1;  ///< number of candidates kept afterwards
};

struct Candidate {
  Alignment alignment;
  double score = 0.0;
};

void descend(const ViewPair& views, const Descent& descent, Candidate& candidate) {
  const double shrink =
      std::pow(descent.last_reach_px / descent.first_reach_px, 1.0 / std::max(1, descent.steps - 1));
  double reach_px = descent.first_reach_px;
  for (int i = 0; i < descent.steps; ++i, reach_px *= shrink) {
    const NormalEquations sum = normal_equations(views, candidate.alignment, reach_px);
    candidate.alignment = moved(candidate.alignment, step_of(sum, candidate.alignment));
  }
  candidate.score = normal_equations(views, candidate.alignment, descent.last_reach_px).score();
}

double distance_m(const Transform& a, const Transform& b) {
  constexpr double bay_m = 0.7;
  const Transform between = a.inverse() * b;
  return between.translation().norm() + bay_m * Eigen::AngleAxisd(between.linear()).angle();
}

// Keeps the `count` best candidates, best first, and only the best of those that converged to one pose.
void keep_best(std::size_t count, std::vector<Candidate>& candidates) {
  constexpr double same_m = 0.02;
  std::ranges::stable_sort(candidates, std::greater{}, &Candidate::score);
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (kept.size() == count) break;
    const bool known = std::ranges::any_of(kept, [&](const Candidate& other) {
      return distance_m(other.alignment.initial_from_final, candidate.alignment.initial_from_final) < same_m;
    });
    if (!known) kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

void descend(const ViewPair& views, const Descent& descent, std::vector<Candidate>& candidates) {
  parallel_bands(static_cast<int>(candidates.size()), [&](int first, int end) {
    for (int i = first; i < end; ++i) descend(views, descent, candidates[static_cast<std::size_t>(i)]);
  });
  keep_best(descent.kept, candidates);
}

std::vector<Candidate> candidates_at(const RegistrationGuess& guess) {
  if (guess.nearby) return {{{guess.initial_from_final, 0.0}, 0.0}};
  std::vector<Candidate> candidates;
  for (const Transform& start : starts_around(guess.initial_from_final))
    candidates.push_back({{start, 0.0}, 0.0});
  return candidates;
}

// Describes a direction as seen by an observer looking along the camera.
std::string_view name_of_direction(const Twist& direction) {
  constexpr std::array<std::string_view, 6> names{
      "a turn up or down",     "a turn left or right", "a turn about the line of sight",
      "a shift left or right", "a shift up or down",   "a shift along the line of sight"};
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return names.at(static_cast<std::size_t>(largest));
}

std::string doubt_of(const Registration& registration, const RegistrationUncertainty& uncertainty,
                     const std::vector<Candidate>& candidates) {
  constexpr double least_overlap = 0.15;
  constexpr double least_agreeing = 0.68;
  constexpr double worst_share = 0.012;  // of the distance
  constexpr double clearly_better = 0.9;
  if (registration.overlap < least_overlap)
    return fmt::format("only {:.0f} % of the views show the same surfaces", 100.0 * registration.overlap);
  if (registration.agreeing < least_agreeing)
    return fmt::format("only {:.0f} % of what both views show lies on the same surfaces",
                       100.0 * registration.agreeing);
  if (uncertainty.worst_m > worst_share * uncertainty.distance_m)
    return fmt::format("nothing in view constrains {}", name_of_direction(uncertainty.worst));
  if (candidates.size() > 1 && candidates[1].score > clearly_better * candidates[0].score) {
    const double apart_m =
        distance_m(candidates[0].alignment.initial_from_final, candidates[1].alignment.initial_from_final);
    return fmt::format("two poses {:.0f} mm apart explain the views equally well", mm_per_m * apart_m);
  }
  return {};
}

/// Planar patches of both views at two resolutions.
struct Planes {
  PlanarPatches initial_coarse;
  PlanarPatches final_coarse;
  PlanarPatches initial_fine;
  PlanarPatches final_fine;
};

/// Searches in stages from coarse to fine: each keeps fewer candidates and ends with a smaller reach.
/// @param every distance between samples in the search, in patches
Registration search(const Planes& planes, const RegistrationGuess& guess, int every) {
  std::vector<Candidate> candidates = candidates_at(guess);
  const ViewPair coarse(planes.initial_coarse, planes.final_coarse, every);
  if (!guess.nearby) {
    descend(coarse, {.steps = 8, .first_reach_px = 24.0, .last_reach_px = 4.0, .kept = 100}, candidates);
    descend(coarse, {.steps = 5, .first_reach_px = 4.0, .last_reach_px = 2.0, .kept = 40}, candidates);
  }
  descend(coarse, {.steps = 6, .first_reach_px = 4.0, .last_reach_px = 1.0, .kept = 8}, candidates);
  const ViewPair denser(planes.initial_coarse, planes.final_coarse, every / 2);
  descend(denser, {.steps = 8, .first_reach_px = 3.0, .last_reach_px = 1.0, .kept = 3}, candidates);
  const ViewPair fine(planes.initial_fine, planes.final_fine, 2);
  descend(fine, {.steps = 6, .first_reach_px = 1.5, .last_reach_px = last_reach_px, .kept = 3}, candidates);
  const Alignment& best = candidates.front().alignment;
  const NormalEquations sum = normal_equations(fine, best, last_reach_px);
  const RegistrationUncertainty uncertain = uncertainty(fine, best, last_reach_px);
  Registration result{.initial_from_final = best.initial_from_final,
                      .covariance = uncertain.covariance,
                      .offset_px = best.offset_px,
                      .agreeing = sum.agreeing / std::max(1.0, sum.compared),
                      .overlap = sum.compared / std::max(1.0, sum.samples),
                      .doubt = {}};
  result.doubt = doubt_of(result, uncertain, candidates);
  return result;
}

}  // namespace

Registration register_views(const DepthView& initial, const DepthView& final,
                            const RegistrationGuess& guess) {
  const Planes planes{.initial_coarse = PlanarPatches(initial, coarse_step_px, window_px),
                      .final_coarse = PlanarPatches(final, coarse_step_px, window_px),
                      .initial_fine = PlanarPatches(initial, fine_step_px, window_px),
                      .final_fine = PlanarPatches(final, fine_step_px, window_px)};
  Registration result = search(planes, guess, 4);
  // Few samples usually suffice; a doubtful result is searched again with more.
  return result.trusted() ? result : search(planes, guess, 2);
}

}  // namespace rva
