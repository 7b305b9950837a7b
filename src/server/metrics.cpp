#include "server/metrics.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>

#include "core/error.hpp"
#include "core/folder_space.hpp"
#include "server/exposition.hpp"
#include "server/health.hpp"

namespace rva {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void add_process(Exposition& metrics, const Traffic::Counts& counts) {
  metrics.family("rva_build_info", "gauge", "Always 1; the label is the version of the program.");
  metrics.sample(1.0, {{"version", RVA_VERSION}});
  metrics.single("rva_uptime_seconds", "gauge", "Time since the server was started.", counts.uptime_s);
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) == 0)
    metrics.single("process_cpu_seconds_total", "counter", "Processor time that the program has used.",
                   seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime));
  std::uint64_t all_pages = 0;
  std::uint64_t resident_pages = 0;
  if (std::ifstream("/proc/self/statm") >> all_pages >> resident_pages)
    metrics.single("process_resident_memory_bytes", "gauge", "Memory of the program.",
                   static_cast<double>(resident_pages) * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

void add_newest_frame(Exposition& metrics, const LiveFrame& live) {
  const auto& depth = live.frame.depth.pixels();
  const auto measured = std::ranges::count_if(depth, [](std::uint16_t units) { return units != no_depth; });
  metrics.single("rva_camera_measured_ratio", "gauge", "Share of the newest depth image with a measurement.",
                 static_cast<double>(measured) / static_cast<double>(depth.size()));
  if (live.frame.metadata.temperature_c)
    metrics.single("rva_camera_temperature_celsius", "gauge", "Temperature of the camera's chip.",
                   *live.frame.metadata.temperature_c);
}

void add_camera(Exposition& metrics, const LiveCamera& camera) {
  const CameraHealth health = camera.health();
  metrics.single("rva_camera_frames_total", "counter", "Frames that the camera delivered.",
                 static_cast<double>(health.frames));
  metrics.single("rva_camera_lost_frames_total", "counter", "Frames that are missing by their numbers.",
                 static_cast<double>(health.lost));
  metrics.single("rva_camera_rate_hertz", "gauge", "Frames a second, over about the last second.",
                 health.rate_hz);
  metrics.single("rva_camera_silence_seconds", "gauge", "Time since the last frame.", health.silence_s);
  if (const auto live = camera.newest()) add_newest_frame(metrics, *live);
}

void add_robot(Exposition& metrics, const Drive& drive) {
  const DriveState state = drive.state();
  metrics.single("rva_robot_connected", "gauge", "1 if the servos report their angles.",
                 state.joints ? 1.0 : 0.0);
  metrics.single("rva_robot_moving", "gauge", "1 if the robot is driven by sticks or for captures.",
                 state.driving || state.lent ? 1.0 : 0.0);
  if (!state.lamp) return;
  metrics.single("rva_lamp_ratio", "gauge", "Brightness of the lamp, 0 to 1.", state.lamp->percent / 100.0);
  if (state.lamp->celsius)
    metrics.single("rva_lamp_celsius", "gauge", "Temperature of the lamp's frame.", *state.lamp->celsius);
}

void add_tasks(Exposition& metrics, const Inspector& inspector) {
  const EndedTasks ended = inspector.ended_tasks();
  metrics.family("rva_tasks_total", "counter", "Tasks that have ended, by kind and end.");
  for (const auto& [kind, kind_name] : enum_names<TaskKind>) {
    for (const auto& [end, end_name] : enum_names<TaskEnd>) {
      if (end == TaskEnd::running) continue;
      const auto found = ended.find({kind, end});
      metrics.sample(found == ended.end() ? 0.0 : static_cast<double>(found->second),
                     {{"kind", std::string(kind_name)}, {"end", std::string(end_name)}});
    }
  }
  const TaskState task = inspector.task();
  metrics.family("rva_task_running", "gauge", "1 for the kind of the task that is running.");
  for (const auto& [kind, kind_name] : enum_names<TaskKind>)
    metrics.sample(task.end == TaskEnd::running && task.kind == kind ? 1.0 : 0.0,
                   {{"kind", std::string(kind_name)}});
}

void add_disk(Exposition& metrics, const std::filesystem::path& data) {
  try {
    const FolderSpace space = space_of(data);
    metrics.single("rva_data_free_bytes", "gauge", "Free space of the disk of the data folder.",
                   static_cast<double>(space.free_bytes));
    metrics.single("rva_data_size_bytes", "gauge", "Size of the disk of the data folder.",
                   static_cast<double>(space.size_bytes));
  } catch (const Error&) {
    return;  // a sample that is missing is what the format has for an unknown value
  }
}

void add_traffic(Exposition& metrics, const Traffic::Counts& counts) {
  metrics.single("rva_consoles", "gauge", "Consoles that are connected.",
                 static_cast<double>(counts.consoles));
  metrics.family("rva_http_request_duration_seconds", "histogram",
                 "From a complete request to its answer, by HTTP status.");
  for (const auto& [status, durations] : counts.requests) metrics.histogram(durations, {{"code", status}});
  metrics.family("rva_picture_delay_seconds", "histogram",
                 "From the delivery of a frame to its encoded picture, by stream.");
  for (const auto& [stream, durations] : counts.pictures) metrics.histogram(durations, {{"stream", stream}});
}

void add_health(Exposition& metrics, const ServerParts& parts) {
  metrics.family("rva_healthy", "gauge", "1 if a check of GET /api/health found no problem, by check.");
  for (const HealthCheck& check : check_health(parts))
    metrics.sample(check.problem.empty() ? 1.0 : 0.0, {{"check", check.name}});
}

}  // namespace

std::string metrics_text(const ServerParts& parts) {
  Exposition metrics;
  const Traffic::Counts counts = parts.traffic->counts();
  add_process(metrics, counts);
  add_health(metrics, parts);
  add_camera(metrics, parts.camera);
  if (parts.drive != nullptr) add_robot(metrics, *parts.drive);
  add_tasks(metrics, parts.inspector);
  add_disk(metrics, parts.inspector.data());
  add_traffic(metrics, counts);
  return metrics.text();
}

}  // namespace rva
