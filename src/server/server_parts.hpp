// The objects that the server works with.
#pragma once

#include <functional>
#include <memory>

#include "audit/package_writer.hpp"
#include "audit/site_keys.hpp"
#include "camera/live_camera.hpp"
#include "inspect/inspector.hpp"
#include "measure/measure_options.hpp"
#include "robot/drive.hpp"
#include "server/data_folder_probe.hpp"
#include "server/frozen_pictures.hpp"
#include "server/lease.hpp"
#include "server/sessions.hpp"
#include "server/traffic.hpp"

namespace rva {

/// Switches a simulated bay to its state after the work (`done`) or before it. May be called from any thread;
/// returns at once.
using SimulatedWork = std::function<void(bool done)>;

/// All of them must outlive the server.
struct ServerParts {
  LiveCamera& camera;
  Drive* drive = nullptr;  ///< null if there is no robot
  Inspector& inspector;
  Sessions& sessions;
  Lease& lease;
  SimulatedWork simulated_work;  ///< empty if the bay is not simulated
  MeasureOptions measure{};      ///< of what people measure
  SiteKeys* keys = nullptr;      ///< of those who sign inspections; null: nobody can
  TimeStamping time_stamping{};  ///< of signed packages; without a server: none
  /// What people froze.
  std::shared_ptr<FrozenPictures> frozen = std::make_shared<FrozenPictures>();
  std::shared_ptr<Traffic> traffic = std::make_shared<Traffic>();  ///< what the server counts
  /// Whether the data folder can be written.
  std::shared_ptr<DataFolderProbe> data_probe = std::make_shared<DataFolderProbe>();
};

}  // namespace rva
