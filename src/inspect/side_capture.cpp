#include "inspect/side_capture.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "capture/frozen.hpp"
#include "core/clock.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "inspect/watched_camera.hpp"
#include "map/view_capture.hpp"
#include "map/view_folder.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

constexpr std::size_t frames_between_noise = 10;

CaptureProgress progress_at(const SideCapture& side, std::size_t waypoint) {
  return {.view = waypoint / side.captures_each,
          .views = side.waypoints.size() / side.captures_each,
          .capture = waypoint % side.captures_each,
          .captures = side.captures_each,
          .frame = 0,
          .frames = side.frames,
          .approach = 0,
          .approaches = side.baseline.empty() ? 1 : static_cast<std::size_t>(side.pose_return.approaches)};
}

/// Reports each frame, and measures the noise of those of one capture. Frames that are used to
/// judge an approach are not part of the capture.
class Witness {
 public:
  Witness(const SideCapture& side, const CaptureEvents& events, CaptureInfo info)
      : events_(events), info_(std::move(info)), watch_(info_), now_(progress_at(side, 0)) {}

  /// @param next progress_at() the capture's waypoint
  void begin(const CaptureProgress& next) {
    now_ = next;
    watch_ = NoiseWatch(info_);
    approaching_ = now_.approaches > 1;
    events_.progress(now_);
  }

  void approached(const ReachedPose& reached, bool last) {
    approaching_ = !last;
    now_.approach = static_cast<std::size_t>(reached.approaches) - (last ? 1 : 0);
    events_.progress(now_);
  }

  /// @throws Error when all frames of a complete capture are the same image
  void see(const CameraFrame& frame) {
    if (approaching_) return events_.progress(now_);
    watch_.add(frame.depth);
    now_.frame = std::min(watch_.frames(), now_.frames);
    events_.progress(now_);
    // Thrown before the last frame is written, so that the capture is never complete.
    if (watch_.frames() == now_.frames && watch_.frozen()) throw frozen_camera("camera");
    if (watch_.frames() % frames_between_noise == 0 || watch_.frames() == now_.frames)
      events_.noise(watch_.measure());
  }

  void tick() const { events_.progress(now_); }

 private:
  const CaptureEvents& events_;
  CaptureInfo info_;
  NoiseWatch watch_;
  CaptureProgress now_;
  bool approaching_ = false;
};

// Long waits for the robot end when the work is to end.
Clock clock_that_asks(const Witness& witness) {
  const Clock real = steady_clock();
  return {real.now_s, [real, &witness](double duration_s) {
            witness.tick();
            real.sleep(duration_s);
          }};
}

// Turns the camera back to where it was before the capture; otherwise the next inspection would begin with
// the pose of this one's last dither step. If the robot fails here, all captures are complete already, and
// its state reports the failure.
void return_to(const PanTilt& start, Robot& robot, const Clock& clock) {
  try {
    approach(robot, start, clock);
  } catch (const Error&) {
    return;
  }
}

void take_with_robot(const InspectionRig& rig, const SideCapture& side, const CaptureEvents& events,
                     const std::function<void()>& while_waiting) {
  const std::unique_ptr<Camera> frames = rig.camera.every_frame(while_waiting);
  Witness witness(side, events, frames->info());
  WatchedCamera camera(*frames, [&](const CameraFrame& frame) { witness.see(frame); });
  const Clock clock = clock_that_asks(witness);
  const Drive::Loan loan(*rig.drive);
  const PanTilt start = rig.drive->limits().nearest(loan.robot().joints());
  // The last call reports that all are complete.
  const Progress progress = [&](std::string_view /*step*/, std::size_t done, std::size_t total) {
    if (done < total) witness.begin(progress_at(side, done));
  };
  ViewCaptureOptions options{side.frames, 1, side.lamp};
  if (!side.baseline.empty())
    options.baseline =
        Baseline{side.baseline, side.captures_each, side.pose_return,
                 [&](const ReachedPose& reached, bool last) { witness.approached(reached, last); }};
  take_views({camera, loan.robot(), clock, rig.chain, side.base}, side.waypoints, side.folder, options,
             progress);
  return_to(start, loan.robot(), clock);
}

void take_standing(const InspectionRig& rig, const SideCapture& side, const CaptureEvents& events,
                   const std::function<void()>& while_waiting) {
  const std::filesystem::path folder = side.folder / view_name(0);
  const std::unique_ptr<Camera> frames = rig.camera.every_frame(while_waiting);
  Witness witness(side, events, frames->info());
  WatchedCamera camera(*frames, [&](const CameraFrame& frame) { witness.see(frame); });
  witness.begin(progress_at(side, 0));
  OutputFolder out(folder, capture_files(), Existing::refuse);
  CaptureWriter writer(out.path(""), camera.info());
  record(camera, side.frames, writer, {});
  if (side.lamp) record_lamp(camera, side.frames, writer, {});
  out.commit();
}

void take_once(const InspectionRig& rig, const SideCapture& side, const CaptureEvents& events,
               const std::function<void()>& while_waiting) {
  if (rig.drive != nullptr)
    take_with_robot(rig, side, events, while_waiting);
  else
    take_standing(rig, side, events, while_waiting);
}

// Why nothing can be taken just now; empty where everything answers.
std::string what_is_away(const InspectionRig& rig) {
  const CameraHealth health = rig.camera.health();
  if (!health.problem.empty()) return health.problem;
  if (rig.camera.wait_for_other(rig.camera.newest().get(), std::chrono::milliseconds(1500)) == nullptr)
    return "camera: gives no frames; check its cable";
  if (rig.drive == nullptr) return {};
  // The state that is known may be of before what failed.
  const DriveState state = rig.drive->state_after_asking();
  return state.joints ? "" : state.problem;
}

// @return whether a device was away, and is back
bool waited_for_device(const InspectionRig& rig, const CaptureEvents& events, const CaptureProgress& where) {
  bool waited = false;
  for (std::string away = what_is_away(rig); !away.empty(); away = what_is_away(rig)) {
    waited = true;
    events.waiting(away);
    events.progress(where);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  if (waited) events.waiting("");
  return waited;
}

}  // namespace

std::string take_side(const InspectionRig& rig, const SideCapture& side, const CaptureEvents& events) {
  CaptureProgress last = progress_at(side, 0);
  CaptureEvents noted = events;
  noted.progress = [&](const CaptureProgress& now) {
    last = now;
    events.progress(now);
  };
  // Long waits for a frame end when the work is to end.
  const std::function<void()> ask_whether_to_end = [&] { events.progress(last); };
  const ViewFolder folder(side.folder, ViewFolder::Start::resume, side.waypoints.size());
  for (bool complete = false; !complete;) {
    try {
      take_once(rig, side, noted, ask_whether_to_end);
      complete = true;
    } catch (const UsageError&) {
      throw;
    } catch (const Error&) {
      if (!waited_for_device(rig, events, last)) throw;
    }
  }
  const std::string taken_at =
      open_capture(side.folder / view_name(side.waypoints.size() - 1))->info().captured_at;
  return taken_at.empty() ? iso_8601_now() : taken_at;
}

}  // namespace rva
