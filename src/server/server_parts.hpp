// What the server stands around.
#pragma once

#include <functional>

#include "camera/live_camera.hpp"
#include "inspect/inspector.hpp"
#include "inspect/records.hpp"
#include "robot/drive.hpp"
#include "server/lease.hpp"
#include "server/sessions.hpp"

namespace rva {

/// Of a bay that exists only as a file: lets the work happen, or begins anew with a clean bay. Called from
/// any thread; returns at once.
using SimulatedWork = std::function<void(bool done)>;

/// All of them outlive the server.
struct ServerParts {
  LiveCamera& camera;
  Drive* drive = nullptr;  ///< null where there is no robot
  Inspector& inspector;
  Sessions& sessions;
  Lease& lease;
  SimulatedWork simulated_work;  ///< empty where the bay is real
};

}  // namespace rva
