#include "evaluate/moved_wing.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "robot/dither.hpp"
#include "scene/debris/random_debris.hpp"
#include "scene/drop_zone.hpp"
#include "scene/traces.hpp"

namespace rva {
namespace {

constexpr double from_ribs_m = 0.18;
constexpr double middle_m = 0.7;  // of the bay, from the near spar

// The area of the lower skin that is in view of a robot.
Eigen::AlignedBox2d before_robot(const CameraStand& stand) {
  constexpr double aside_m = 0.3;
  const double ahead_m = 0.5 * stand.position_m.x();  // robots face the middle of the bay
  return {Eigen::Vector2d(ahead_m - aside_m, 0.3), Eigen::Vector2d(ahead_m + aside_m, 0.95)};
}

// A static camera detects smaller objects, so more of them are placed for it, all within its view.
void drop(Scene& scene, CameraReturn how, std::uint64_t seed) {
  const Eigen::AlignedBox2d floor(scene.bay.min().head<2>(), scene.bay.max().head<2>());
  const bool stayed = how != CameraReturn::elsewhere;
  RandomDebris debris;
  debris.seed = seed;
  debris.within = floor;
  debris.from_m = default_look_down_m(scene);
  debris.count = 5;
  debris.kinds = {"flashlight", "flashlight-small", "screwdriver", "socket", "tape-roll", "glove", "clip",
                  "rag"};
  (void)place_at_random(debris, scene);
  debris.group = 1;
  debris.count = stayed ? 12 : 4;
  if (stayed) debris.within = floor.intersection(before_robot(scene.stand));
  debris.kinds = {"collar-0.27", "collar-0.36", "collar-0.44", "collar-0.53", "bolt-m6", "nut-plate"};
  (void)place_at_random(debris, scene);
}

void stand_somewhere(const Eigen::AlignedBox3d& bay, Random& random, CameraStand& stand) {
  constexpr double deg = 180.0 / std::numbers::pi;
  const double reach_m = bay.max().x() - from_ribs_m;
  stand.position_m = {random.uniform(-reach_m, reach_m), random.uniform(0.05, 0.25), 0.0};
  const double ahead_deg = deg * std::atan2(stand.position_m.x(), middle_m - stand.position_m.y());
  stand.heading_deg = ahead_deg + random.uniform(-5.0, 5.0);
}

bool moved_as_wanted(const CameraStand& a, const CameraStand& b) {
  const double move_m = (a.position_m - b.position_m).norm();
  return move_m >= 0.15 && move_m <= 0.4 && std::abs(a.heading_deg - b.heading_deg) <= 15.0;
}

double one_or_two_steps_deg(Random& random) {
  const double steps = random.uniform(0.0, 1.0) < 0.5 ? 1.0 : 2.0;
  return (random.uniform(0.0, 1.0) < 0.5 ? -steps : steps) * servo_step_deg;
}

// Turns only the camera.
void stay(CameraReturn how, Random& random, const CameraStand& after, CameraStand& before) {
  before = after;
  if (how == CameraReturn::exact || how == CameraReturn::rest) return;
  before.pan_deg += one_or_two_steps_deg(random);
  before.tilt_deg += one_or_two_steps_deg(random);
}

}  // namespace

MovedWing random_moved_wing(std::uint64_t seed, CameraReturn how, const BayFeatures& features) {
  MovedWing wing;
  wing.before = random_wing(seed, features);
  wing.after = wing.before;
  Random random(mix(seed, 0x30BE));
  CameraStand& before = wing.before.stand;
  CameraStand& after = wing.after.stand;
  before.base = "b1";
  after.base = "b2";
  before.pan_deg = after.pan_deg = 0.0;
  after.tilt_deg = random.uniform(-28.0, -18.0);
  before.tilt_deg = after.tilt_deg + random.uniform(-2.0, 2.0);
  do {
    stand_somewhere(wing.after.bay, random, after);
    stand_somewhere(wing.after.bay, random, before);
  } while (!moved_as_wanted(before, after));
  if (how != CameraReturn::elsewhere) stay(how, random, after, before);
  if (features.work) do_work(random_wing_bay(seed, features), random_work(seed), wing.after);
  if (features.traces) leave_traces(random_traces(seed), wing.after);
  drop(wing.after, how, seed);
  return wing;
}

}  // namespace rva
