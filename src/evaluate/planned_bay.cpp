#include "evaluate/planned_bay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/units.hpp"
#include "evaluate/mechanic.hpp"
#include "evaluate/random_wing.hpp"
#include "plan/plan_areas.hpp"

namespace rva {
namespace {

constexpr double spare_mm = 1.0;
constexpr int fewest_in_a_row = 5;
constexpr int fewest_parts = 20;
constexpr std::array<std::string_view, 5> kinds{"collar-0.36", "collar-0.44", "collar-0.53", "bolt-m6",
                                                "nut-m6"};

// Parts of one kind, one beside the other, all on one surface; empty where there is no room.
std::vector<SceneObject> row_of(const Mechanic& mechanic, const Scene& bay, int most, Random& random) {
  const std::string_view kind = kinds.at(random.bits() % kinds.size());
  const double pitch_m = m_per_mm * random.uniform(25.0, 40.0);
  const double y_m = random.uniform(0.25, 0.85);
  double x_m = random.uniform(bay.bay.min().x(), 0.0);
  std::vector<SceneObject> row;
  for (int k = 0; k < most && x_m < bay.bay.max().x(); ++k, x_m += pitch_m) {
    auto part = mechanic.put(kind, {x_m, y_m}, 0.0, Role::work);
    const bool fits =
        part && (row.empty() || std::abs(part->world_from_object.translation().z() -
                                         row.front().world_from_object.translation().z()) < 1e-3);
    if (fits)
      row.push_back(std::move(*part));
    else if (static_cast<int>(row.size()) >= fewest_in_a_row)
      break;
    else
      row.clear();
  }
  return static_cast<int>(row.size()) >= fewest_in_a_row ? row : std::vector<SceneObject>();
}

Eigen::AlignedBox3d extent_of(const std::vector<SceneObject>& row) {
  Eigen::AlignedBox3d extent;
  for (const SceneObject& part : row) extent.extend(bounds(world_mesh(part)));
  return extent;
}

PlanPoint plan_point(const Eigen::Vector3d& seen) { return {seen.hnormalized(), seen.z()}; }

PlannedItem item_of(const std::vector<SceneObject>& row, const std::string& name, const Mechanic& mechanic) {
  constexpr double around_m = 0.015;
  PlannedItem item;
  item.name = name;
  item.count = static_cast<int>(row.size());
  const Eigen::AlignedBox3d extent = extent_of(row);
  const Eigen::Vector3d one_mm = mm_per_m * bounds(world_mesh(row.front())).sizes();
  item.height_mm = {one_mm.z() - spare_mm, one_mm.z() + spare_mm};
  item.size_mm = RangeMm{one_mm.maxCoeff() - spare_mm, one_mm.maxCoeff() + spare_mm};
  std::vector<PlanPoint>& area = item.areas.emplace_back();
  const double z_m = extent.center().z();
  for (const auto& [x_m, y_m] : {std::pair{extent.min().x() - around_m, extent.min().y() - around_m},
                                 std::pair{extent.max().x() + around_m, extent.min().y() - around_m},
                                 std::pair{extent.max().x() + around_m, extent.max().y() + around_m},
                                 std::pair{extent.min().x() - around_m, extent.max().y() + around_m}})
    area.push_back(plan_point(mechanic.seen({x_m, y_m, z_m})));
  for (const SceneObject& part : row)
    item.places.push_back(plan_point(mechanic.seen(bounds(world_mesh(part)).center())));
  return item;
}

using Rows = std::vector<std::vector<SceneObject>>;

// Also rows on different surfaces are apart in the picture, since areas of a plan must not overlap.
bool is_apart(const PlannedItem& item, const std::vector<PlannedItem>& others) {
  return std::ranges::none_of(others, [&](const PlannedItem& other) { return overlap(item, other); });
}

// Fewer than 20 parts where the view has no room for more.
Rows random_rows(const Mechanic& mechanic, const Scene& bay, Random& random,
                 std::vector<PlannedItem>& items) {
  constexpr int most = 60;
  constexpr int most_in_a_row = 24;
  constexpr int tries = 400;
  const int wanted = fewest_parts + static_cast<int>(random.bits() % (most - fewest_parts + 1));
  Rows rows;
  int parts = 0;
  for (int k = 0; k < tries && wanted - parts >= fewest_in_a_row; ++k) {
    std::vector<SceneObject> row = row_of(mechanic, bay, std::min(most_in_a_row, wanted - parts), random);
    if (row.empty()) continue;
    const PlannedItem item =
        item_of(row, fmt::format("{} in row {}", row.front().kind, rows.size() + 1), mechanic);
    if (!is_apart(item, items)) continue;
    parts += item.count;
    items.push_back(item);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<SceneObject> lost_object(const Mechanic& mechanic, const Scene& bay, const Rows& rows,
                                       Random& random) {
  constexpr int tries = 1000;
  constexpr double clear_m = 0.012;
  for (int k = 0; k < tries; ++k) {
    const Eigen::Vector2d at(random.uniform(bay.bay.min().x(), bay.bay.max().x()),
                             random.uniform(0.25, 0.85));
    const std::string_view kind = kinds.at(random.bits() % kinds.size());
    auto lost = mechanic.put(kind, at, random.uniform(0.0, 360.0), Role::debris);
    if (!lost) continue;
    const Eigen::AlignedBox3d extent = bounds(world_mesh(*lost));
    const bool is_clear = std::ranges::all_of(rows, [&](const auto& row) {
      return std::ranges::all_of(row, [&](const SceneObject& part) {
        return extent.exteriorDistance(bounds(world_mesh(part))) > clear_m;
      });
    });
    if (is_clear) return lost;
  }
  return std::nullopt;
}

// Leaves out one part by chance, and names all others.
void install(Rows rows, Random& random, PlannedBay& bay) {
  const std::size_t row = random.bits() % rows.size();
  const std::size_t part = random.bits() % rows[row].size();
  bay.item = bay.plan.items[row].name;
  bay.place = static_cast<int>(part) + 1;
  rows[row].erase(rows[row].begin() + static_cast<std::ptrdiff_t>(part));
  int number = 0;
  for (std::vector<SceneObject>& parts : rows) {
    for (SceneObject& object : parts) {
      object.name = fmt::format("part-{}", ++number);
      bay.after.objects.push_back(std::move(object));
    }
  }
}

std::optional<PlannedBay> planned_bay(std::uint64_t seed) {
  PlannedBay bay;
  bay.before = bay.after = random_wing(seed);
  Random random(mix(seed, 0x91A2));
  const Mechanic mechanic(bay.before);
  bay.plan.coordinates = PlanCoordinates::metres;
  const Rows rows = random_rows(mechanic, bay.before, random, bay.plan.items);
  const std::size_t parts =
      std::accumulate(rows.begin(), rows.end(), std::size_t{0},
                      [](std::size_t sum, const std::vector<SceneObject>& row) { return sum + row.size(); });
  if (parts < fewest_parts) return std::nullopt;
  std::optional<SceneObject> lost = lost_object(mechanic, bay.before, rows, random);
  if (!lost) return std::nullopt;
  install(rows, random, bay);
  lost->name = "lost";
  bay.after.objects.push_back(std::move(*lost));
  return bay;
}

}  // namespace

// Bays whose view has no room for 20 parts are drawn again.
PlannedBay random_planned_bay(std::uint64_t seed) {
  for (std::uint64_t draw = 0;; ++draw) {
    if (auto bay = planned_bay(draw == 0 ? seed : mix(seed, draw))) return std::move(*bay);
  }
}

Plan without_places(Plan plan) {
  for (PlannedItem& item : plan.items) item.places.clear();
  return plan;
}

}  // namespace rva
