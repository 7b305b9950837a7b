#include "robot/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

constexpr std::chrono::milliseconds period{40};

double now_s() { return steady_clock().now_s(); }

// A worn stick does not rest exactly in its centre. Without this dead zone, the camera would creep, and the
// stick would never count as released, so that driving could not resume after a stop.
double within_one(double deflection) {
  constexpr double at_rest = 0.02;
  if (std::isnan(deflection) || std::abs(deflection) < at_rest) return 0.0;
  return std::clamp(deflection, -1.0, 1.0);
}

// The next target, no farther ahead of the joint than `most_ahead_deg`, and within its limits.
double ahead(double target_deg, double step_deg, double joint_deg, double most_ahead_deg,
             const AxisLimits& limits) {
  const double wanted_deg =
      std::clamp(target_deg + step_deg, joint_deg - most_ahead_deg, joint_deg + most_ahead_deg);
  return std::clamp(wanted_deg, limits.min_deg, limits.max_deg);
}

bool pushes_against(double deflection, double target_deg, const AxisLimits& limits) {
  return (deflection > 0.0 && target_deg >= limits.max_deg) ||
         (deflection < 0.0 && target_deg <= limits.min_deg);
}

}  // namespace

Drive::Drive(Robot& robot, const DriveOptions& options)
    : robot_(robot), options_((check_options(options), options)), limits_(robot.limits()) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Drive::~Drive() = default;

void Drive::steer(const Deflection& deflection) {
  const std::lock_guard lock(mutex_);
  const Deflection within{within_one(deflection.pan), within_one(deflection.tilt)};
  news_ = news_ || within != deflection_;
  deflection_ = within;
  said_s_ = now_s();
  if (within == Deflection{}) state_.armed = true;
  changed_.notify_all();
}

void Drive::halt() {
  const std::lock_guard lock(mutex_);
  halt_ = true;
  news_ = true;
  deflection_ = {};
  state_.armed = false;
  changed_.notify_all();
}

DriveState Drive::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

DriveState Drive::state_after_asking() {
  std::unique_lock lock(mutex_);
  const std::uint64_t next = questions_ + 1;
  changed_.wait(lock, [&] { return answers_ >= next; });
  return state_;
}

Drive::Loan::Loan(Drive& drive) : drive_(drive) {
  constexpr std::chrono::seconds longest_wait{2};  // in case the robot does not answer
  std::unique_lock lock(drive_.mutex_);
  ++drive_.loans_;
  drive_.state_.lent = true;
  drive_.state_.armed = false;
  drive_.news_ = true;
  drive_.changed_.notify_all();
  drive_.changed_.wait_for(lock, longest_wait, [&] { return !drive_.news_ && !drive_.state_.driving; });
}

Drive::Loan::~Loan() {
  const std::lock_guard lock(drive_.mutex_);
  drive_.state_.lent = --drive_.loans_ > 0;
}

void Drive::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    follow(take_orders());
    ask_joints();
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, period, [this] { return news_; });
  }
  if (target_) follow({{}, true});
}

// Without new deflections, driving is disarmed: sticks that were held when the connection was lost must not
// move the robot when it is restored.
Drive::Orders Drive::take_orders() {
  const std::lock_guard lock(mutex_);
  const double silence_s = static_cast<double>(options_.silence_ms) / 1000.0;
  const bool held = deflection_ != Deflection{};
  if (held && (state_.lent || now_s() - said_s_ > silence_s)) {
    state_.armed = false;
    deflection_ = {};
  }
  Orders orders{state_.armed ? deflection_ : Deflection{}, halt_};
  news_ = false;
  return orders;
}

void Drive::follow(const Orders& orders) {
  try {
    if (orders.halt) {
      robot_.stop();
      target_.reset();
      const std::lock_guard lock(mutex_);
      halt_ = false;  // only after the robot has taken it: a failed stop is repeated
    } else if (orders.deflection != Deflection{}) {
      advance(orders.deflection);
    } else {
      stop_moving();
    }
  } catch (const Error& error) {
    failure_ = error.what();
    const std::lock_guard lock(mutex_);
    state_.armed = false;
  } catch (const Interrupted&) {
    halt();
  }
  const std::lock_guard lock(mutex_);
  changed_.notify_all();
  state_.driving = target_.has_value();
  state_.at_limit = target_ && (pushes_against(orders.deflection.pan, target_->pan_deg, limits_.pan) ||
                                pushes_against(orders.deflection.tilt, target_->tilt_deg, limits_.tilt));
}

void Drive::advance(const Deflection& deflection) {
  constexpr double most_ahead_s = 0.25;
  const PanTilt joints = robot_.joints();
  const double now = now_s();
  const double period_s = std::chrono::duration<double>(period).count();
  const double passed_s = target_ ? std::min(now - advanced_s_, 3.0 * period_s) : period_s;
  const PanTilt target = target_.value_or(joints);
  const double most_ahead_deg = options_.speed_deg_s * most_ahead_s;
  const double step_deg = options_.speed_deg_s * passed_s;
  target_ = PanTilt{
      ahead(target.pan_deg, deflection.pan * step_deg, joints.pan_deg, most_ahead_deg, limits_.pan),
      ahead(target.tilt_deg, deflection.tilt * step_deg, joints.tilt_deg, most_ahead_deg, limits_.tilt)};
  advanced_s_ = now;
  robot_.move_to(*target_);
  failure_.clear();
}

void Drive::stop_moving() {
  if (!target_) return;
  robot_.stop();
  target_.reset();
}

void Drive::ask_joints() {
  {
    const std::lock_guard lock(mutex_);
    ++questions_;
  }
  std::optional<PanTilt> joints;
  const std::optional<LampState> lamp = robot_.lamp();
  std::string problem = failure_;
  try {
    joints = robot_.joints();
  } catch (const Error& error) {
    problem = error.what();
  }
  const std::lock_guard lock(mutex_);
  state_.joints = joints;
  state_.problem = problem;
  state_.lamp = lamp;
  answers_ = questions_;
  changed_.notify_all();
}

}  // namespace rva
