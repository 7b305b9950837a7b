// Everything that a server stands around, small and quick.
#pragma once

#include <memory>
#include <stdexcept>

#include "server/server_parts.hpp"
#include "sim/simulated_robot.hpp"
#include "store/sqlite_records.hpp"
#include "tests/eventually.hpp"
#include "tests/inspect/waving_camera.hpp"
#include "tests/temporary_folder.hpp"

namespace rva::test {

struct Served {
  TemporaryFolder folder;
  std::shared_ptr<Plug> plug = std::make_shared<Plug>();
  LiveCamera camera{std::make_unique<WavingCamera>(plug), 200.0};
  SimulatedRobot robot;
  Drive drive{robot};
  SqliteRecords records{folder / "rva.db"};
  Inspector inspector{{camera, &drive}, records, folder.path(), {.readiness = {.least_free_gb = 0.0}}};
  Sessions sessions{records};
  Lease lease;

  /// The robot has said where it stands.
  Served() {
    if (!eventually([&] { return drive.state().joints.has_value(); }))
      throw std::runtime_error("the robot has not reported its joint angles");
  }

  [[nodiscard]] ServerParts parts() { return {camera, &drive, inspector, sessions, lease, {}}; }
};

}  // namespace rva::test
