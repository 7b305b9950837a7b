// Random bays with planned work, its plan, one part that is missing and one object that was lost.
#pragma once

#include <cstdint>
#include <string>

#include "plan/plan.hpp"
#include "scene/scene.hpp"

namespace rva {

/// A bay before and after planned work.
struct PlannedBay {
  Scene before;      ///< without the work
  Scene after;       ///< with the planned parts but one, and with one lost object
  Plan plan;         ///< one item for each row, with its area and the place of each part, in metres
  std::string item;  ///< of which a part is missing
  int place = 0;     ///< number of the missing part in the item's places, from 1
};

/// A bay of random_wing() with 20 to 60 parts in rows: collars, bolts and nuts, 25 to 40 mm apart, a kind for
/// each row, standing on stringers and skins. A row is in full view of the camera and within 0.6 m, as is
/// the lost object, a collar, bolt or nut that lies anywhere else on the same surfaces.
[[nodiscard]] PlannedBay random_planned_bay(std::uint64_t seed);

/// The plan without the places of the parts: their numbers and areas remain.
[[nodiscard]] Plan without_places(Plan plan);

}  // namespace rva
