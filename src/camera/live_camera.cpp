#include "camera/live_camera.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "core/clock.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

constexpr std::size_t most_waiting = 30;
constexpr std::chrono::milliseconds longest_silence{5000};
constexpr std::chrono::milliseconds before_another_try{500};
constexpr std::chrono::milliseconds between_questions{100};

}  // namespace

/// The frames that one recorder has not taken yet; guarded by the mutex of the LiveCamera.
class LiveCamera::Reader : public Camera {
 public:
  Reader(LiveCamera& live, std::function<void()> while_waiting)
      : live_(live), while_waiting_(std::move(while_waiting)), problems_(0) {
    const std::lock_guard lock(live_.mutex_);
    problems_ = live_.problems_;
    last_ = live_.newest_;
    live_.readers_.push_back(this);
  }
  ~Reader() override {
    const std::lock_guard lock(live_.mutex_);
    live_.readers_.remove(this);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void push(const std::shared_ptr<const LiveFrame>& frame, Light light) {
    if (light != light_ || std::exchange(next_is_early_, false)) return;
    if (waiting_.size() == most_waiting) waiting_.pop_front();
    waiting_.push_back(frame);
  }

  [[nodiscard]] CaptureInfo info() const override {
    std::unique_lock lock(live_.mutex_);
    static_cast<void>(wait(lock, [&] { return last_ || !waiting_.empty(); }));
    if (last_) return last_->info;
    if (!waiting_.empty()) return waiting_.front()->info;
    throw silent();
  }

  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    std::unique_lock lock(live_.mutex_);
    const bool came = wait(lock, [&] { return !waiting_.empty() || problems_ != live_.problems_; });
    if (waiting_.empty()) {
      if (!came) throw silent();
      problems_ = live_.problems_;
      throw Error(*live_.failure_);
    }
    last_ = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    return last_->frame;
  }

  // The next frame may have been exposed before this call, and is dropped as well.
  void drop_waiting() override {
    const std::lock_guard lock(live_.mutex_);
    waiting_.clear();
    next_is_early_ = true;
  }

  [[nodiscard]] bool has_lamp() const override { return live_.has_lamp(); }

  void set_light(Light light) override {
    const std::lock_guard lock(live_.mutex_);
    light_ = light;
    waiting_.clear();
  }

  [[nodiscard]] Light light() const { return light_; }

 private:
  // @return whether the condition became true within longest_silence
  template <typename Condition>
  [[nodiscard]] bool wait(std::unique_lock<std::mutex>& lock, const Condition& condition) const {
    const auto end = std::chrono::steady_clock::now() + longest_silence;
    bool came = condition();
    while (!came && std::chrono::steady_clock::now() < end) {
      throw_if_interrupted();
      if (while_waiting_) {
        lock.unlock();
        while_waiting_();
        lock.lock();
      }
      came = live_.changed_.wait_for(lock, between_questions, condition);
    }
    throw_if_interrupted();
    return came;
  }

  [[nodiscard]] static Error silent() {
    return {"camera", "has given no frame for five seconds", "check its cable, or connect it again"};
  }

  LiveCamera& live_;
  std::function<void()> while_waiting_;
  std::uint64_t problems_;
  std::deque<std::shared_ptr<const LiveFrame>> waiting_;
  std::shared_ptr<const LiveFrame> last_;
  bool next_is_early_ = true;
  Light light_ = Light::projector;
};

LiveCamera::LiveCamera(std::unique_ptr<Camera> camera, double most_hz)
    : camera_(std::move(camera)),
      most_hz_(most_hz),
      last_frame_s_(steady_clock().now_s()),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

LiveCamera::~LiveCamera() = default;

void LiveCamera::run(const std::stop_token& stop) {
  const std::chrono::duration<double> period(1.0 / most_hz_);
  while (!stop.stop_requested()) {
    const auto next = std::chrono::steady_clock::now() + period;
    try {
      set_wanted_exposure();
      const Light light = wanted_light();
      camera_->set_light(light);
      std::optional<CameraFrame> frame = camera_->wait_for_frame();
      if (!frame) {
        report(Error("camera", "the recording has ended", "give a capture with more frames"));
        return;
      }
      publish(std::move(*frame), light);
      std::this_thread::sleep_until(next);
    } catch (const Interrupted&) {
      return;
    } catch (const Error& error) {
      report(error);
      std::this_thread::sleep_for(before_another_try);
    }
  }
}

// The lamp is on while at least one recorder asks for it.
Light LiveCamera::wanted_light() const {
  const std::lock_guard lock(mutex_);
  const bool lamp =
      std::ranges::any_of(readers_, [](const Reader* reader) { return reader->light() == Light::lamp; });
  return lamp ? Light::lamp : Light::projector;
}

void LiveCamera::set_wanted_exposure() {
  std::unique_lock lock(mutex_);
  const std::optional<Exposure> wanted = std::exchange(wanted_exposure_, std::nullopt);
  lock.unlock();
  if (wanted) camera_->set_exposure(*wanted);
}

void LiveCamera::publish(CameraFrame frame, Light light) {
  auto live = std::make_shared<LiveFrame>(
      LiveFrame{std::move(frame), camera_->info(), std::chrono::system_clock::now()});
  const double now_s = steady_clock().now_s();
  const std::optional<ExposureControl> exposure_control = camera_->exposure_control();
  const std::lock_guard lock(mutex_);
  exposure_control_ = exposure_control;
  if (last_number_) {
    health_.lost += live->frame.number - *last_number_ - 1;
    constexpr double share = 0.1;
    const double rate_hz = 1.0 / std::max(1e-3, now_s - last_frame_s_);
    health_.rate_hz += health_.frames < 2 ? rate_hz : share * (rate_hz - health_.rate_hz);
  }
  last_number_ = live->frame.number;
  last_frame_s_ = now_s;
  ++health_.frames;
  health_.problem.clear();
  for (Reader* reader : readers_) reader->push(live, light);
  if (light == Light::projector) newest_ = std::move(live);
  changed_.notify_all();
}

void LiveCamera::report(const Error& failure) {
  const std::lock_guard lock(mutex_);
  failure_ = failure;
  health_.problem = failure.what();
  health_.rate_hz = 0.0;
  ++problems_;
  changed_.notify_all();
}

std::shared_ptr<const LiveFrame> LiveCamera::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::shared_ptr<const LiveFrame> LiveCamera::wait_for_other(const LiveFrame* seen,
                                                            std::chrono::milliseconds limit) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, limit, [&] { return newest_ && newest_.get() != seen; });
  return newest_.get() == seen ? nullptr : newest_;
}

std::optional<ExposureControl> LiveCamera::exposure_control() const {
  const std::lock_guard lock(mutex_);
  return exposure_control_;
}

void LiveCamera::set_exposure(const Exposure& exposure) {
  const std::lock_guard lock(mutex_);
  if (!exposure_control_)
    throw Error("camera", "its exposure cannot be set", "move it, or change the light in the bay");
  check_exposure(exposure, *exposure_control_);
  wanted_exposure_ = exposure;
}

std::unique_ptr<Camera> LiveCamera::every_frame(std::function<void()> while_waiting) {
  return std::make_unique<Reader>(*this, std::move(while_waiting));
}

CameraHealth LiveCamera::health() const {
  const std::lock_guard lock(mutex_);
  CameraHealth health = health_;
  health.silence_s = steady_clock().now_s() - last_frame_s_;
  return health;
}

}  // namespace rva
