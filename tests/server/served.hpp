// Everything that a server stands around, small and quick.
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "server/server_parts.hpp"
#include "sim/simulated_robot.hpp"
#include "store/sqlite_records.hpp"
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
    while (!drive.state().joints) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  [[nodiscard]] ServerParts parts() { return {camera, &drive, inspector, sessions, lease, {}}; }
};

}  // namespace rva::test
