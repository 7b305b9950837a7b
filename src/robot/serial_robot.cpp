#include "robot/serial_robot.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "robot/robot_lines.hpp"
#include "robot/serial_link.hpp"

namespace rva {
namespace {

using Time = std::chrono::steady_clock::time_point;
using std::chrono::milliseconds;

constexpr milliseconds ping_every{100};
constexpr milliseconds answer_within{100};
constexpr int tries = 5;
constexpr milliseconds position_counts{250};
constexpr milliseconds lamp_counts{2000};  // the robot reports its lamp twice a second
constexpr milliseconds found_within{4000};
constexpr milliseconds known_within{5000};
constexpr milliseconds ready_within{1000};
// RVA's firmware sends READY every second until it is commanded, so that after this time a robot is a
// bare one.
constexpr milliseconds bare_after{2500};
constexpr milliseconds bare_rests_after{150};
constexpr double bare_rests_deg = 0.4;

Time now() { return std::chrono::steady_clock::now(); }

/// A joint's last measured angle.
struct Measured {
  double deg = 0.0;
  Time at{};
};

}  // namespace

/// The state of the robot, and the exchange with it. Lines arrive on the link's thread, requests on any.
class SerialRobot::Conversation {
 public:
  explicit Conversation(std::string device)
      : device_(std::move(device)),
        link_(device_,
              {[this] { begin(); }, [this](std::string_view line) { hear(line); }, [this] { forget(); }}),
        keeper_([this](const std::stop_token& stop) { keep_in_sight(stop); }) {}

  void wait_until_known() {
    wait_for(known_within, [this] { return kind_ != RobotKind::unknown; });
    const std::scoped_lock lock(mutex_);
    if (kind_ == RobotKind::unknown) throw no_robot();
  }

  // A board that has just started first finds its servos. There may be none, so that this is not an error.
  void wait_until_ready() {
    wait_for(ready_within, [this] { return pan_ && tilt_ && state_since_command_ != "START"; });
  }

  [[nodiscard]] RobotKind kind() const {
    const std::scoped_lock lock(mutex_);
    return kind_;
  }
  [[nodiscard]] std::string firmware() const {
    const std::scoped_lock lock(mutex_);
    return ready_ ? ready_->firmware : "";
  }
  [[nodiscard]] RobotLimits limits() const {
    const std::scoped_lock lock(mutex_);
    return ready_ ? ready_->limits : RobotLimits{};
  }

  void move_to(const PanTilt& target) {
    limits().check(target);
    if (kind_or_throw() == RobotKind::framed) {
      ask(move_body(target));
      const std::scoped_lock lock(mutex_);
      state_since_command_.reset();
      return;
    }
    const auto whole = [](double deg) { return static_cast<int>(std::lround(deg)); };
    link_.write(fmt::format("{}.{}", whole(target.pan_deg), whole(target.tilt_deg)));
    const std::scoped_lock lock(mutex_);
    bare_moved_at_ = now();
  }

  [[nodiscard]] std::optional<LampState> lamp() const {
    const std::scoped_lock lock(mutex_);
    if (kind_ != RobotKind::framed || now() - lamp_at_ > lamp_counts) return std::nullopt;
    return lamp_;
  }

  void set_lamp(int percent) {
    check_lamp_percent(percent);
    if (kind_or_throw() != RobotKind::framed || !lamp())
      throw Error(
          device_, "the robot has no lamp, or its thermistor is not connected",
          "check the lamp's cable, and load the firmware of this version of rva (firmware/README.md)");
    ask(lamp_body(percent));
  }

  [[nodiscard]] std::vector<int> find_servos() {
    require_framed();
    {
      const std::scoped_lock lock(mutex_);
      found_.reset();
    }
    ask("FIND");
    wait_for(found_within, [this] { return found_.has_value(); });
    const std::scoped_lock lock(mutex_);
    if (!found_) throw Error(device_, "the robot does not report its servos", "try again");
    return *found_;
  }

  void name_servo(int from, int to) {
    for (const int id : {from, to}) check_id(id);
    require_framed();
    ask(name_body(from, to));
  }

  void turn_to_middle(int id) {
    check_id(id);
    require_framed();
    ask(middle_body(id));
  }

  [[nodiscard]] PanTilt joints() const {
    const std::scoped_lock lock(mutex_);
    if (kind_ == RobotKind::unknown) throw away();
    for (const std::optional<Measured>* joint : {&pan_, &tilt_}) {
      if (!*joint || now() - (*joint)->at > position_counts)
        throw Error(device_, "the joint angles are unknown", "check the servos' power and their cable");
    }
    return {pan_->deg, tilt_->deg};
  }

  [[nodiscard]] bool moving() {
    if (kind_or_throw() == RobotKind::bare) {
      (void)joints();
      const std::scoped_lock lock(mutex_);
      return now() - bare_moved_at_ < bare_rests_after;
    }
    const std::string state = next_state();
    if (state == "FAULT")
      throw Error(device_, "a servo is at fault, and its torque is off",
                  "let it cool, remove obstacles, and check its power");
    if (state == "LOST")
      throw Error(device_, "the robot stopped, since it received nothing from this program for half a second",
                  "check the cable, and move it again");
    return state == "MOVE";
  }

  void stop() {
    if (kind_or_throw() == RobotKind::framed) {
      link_.write("!");
      ask("STOP");
      return;
    }
    const PanTilt here = joints();
    move_to({std::round(here.pan_deg), std::round(here.tilt_deg)});
  }

 private:
  template <typename Condition>
  void wait_for(milliseconds longest, const Condition& condition) {
    const Time end = now() + longest;
    std::unique_lock lock(mutex_);
    while (!condition() && now() < end) {
      throw_if_interrupted();
      changed_.wait_for(lock, milliseconds(20));
    }
  }

  Error away() const {
    return {device_, "the robot is disconnected", "connect it: it is then found automatically"};
  }
  Error no_robot() const {
    return heard_anything_
               ? Error(device_, "the device does not respond like a robot",
                       "give the robot's device, or load its firmware (firmware/README.md)")
               : Error(device_, "no data is received",
                       "give the robot's device, check its power, or load its firmware (firmware/README.md)");
  }

  [[nodiscard]] RobotKind kind_or_throw() const {
    const RobotKind kind = this->kind();
    if (kind == RobotKind::unknown) throw away();
    return kind;
  }

  static void check_id(int id) {
    if (id < 0 || id > greatest_servo_id)
      throw UsageError("servo", fmt::format("{} is not an ID", id), "give 0 to 253");
  }

  void require_framed() const {
    if (kind_or_throw() != RobotKind::framed)
      throw Error(device_, "the robot has the thesis' firmware, which cannot do this",
                  "load the firmware of this version of rva (firmware/README.md)");
  }

  // These are called on the link's thread.
  void begin() {
    const std::scoped_lock lock(mutex_);
    opened_at_ = now();
  }
  void forget() {
    {
      const std::scoped_lock lock(mutex_);
      kind_ = RobotKind::unknown;
      pan_.reset();
      tilt_.reset();
      state_since_command_.reset();
      answers_.clear();
    }
    changed_.notify_all();
  }
  void hear(std::string_view text) {
    const std::optional<RobotLine> line = parse_robot_line(text);
    {
      const std::scoped_lock lock(mutex_);
      heard_anything_ = true;
      if (line) std::visit([this](const auto& said) { take(said); }, *line);
    }
    changed_.notify_all();
  }

  void take(const ReadyLine& ready) {
    if (ready.protocol != 1) return;
    ready_ = ready;
    kind_ = RobotKind::framed;
  }
  void take(const AnswerLine& answer) { answers_[answer.number] = answer; }
  void take(const PositionsLine& positions) {
    // A board that was not reset sends positions without READY first: it is asked for its identity.
    if (kind_ == RobotKind::unknown) link_.write(robot_frame(0, "INFO"));
    const auto measured = [](const JointPosition& joint) {
      return Measured{joint.deg, now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                             std::chrono::duration<double>(joint.age_s))};
    };
    if (positions.pan) pan_ = measured(*positions.pan);
    if (positions.tilt) tilt_ = measured(*positions.tilt);
    state_since_command_ = positions.state;
  }
  void take(const StatusLine& /*status*/) {}
  void take(const FoundLine& line) { found_ = line.ids; }
  void take(const LampLine& line) {
    lamp_ = line.lamp;
    lamp_at_ = now();
  }
  void take(const BarePositionsLine& positions) {
    if (kind_ == RobotKind::framed) return;
    if (kind_ == RobotKind::unknown && now() - opened_at_ > bare_after) kind_ = RobotKind::bare;
    const bool turned = pan_ && tilt_ &&
                        (std::abs(pan_->deg - positions.joints.pan_deg) > bare_rests_deg ||
                         std::abs(tilt_->deg - positions.joints.tilt_deg) > bare_rests_deg);
    if (turned) bare_moved_at_ = now();
    pan_ = Measured{positions.joints.pan_deg, now()};
    tilt_ = Measured{positions.joints.tilt_deg, now()};
  }

  // Repeats the command until it is answered. All commands may be executed twice.
  void ask(const std::string& body) {
    const std::scoped_lock one_at_a_time(asking_);
    for (int i = 0; i < tries; ++i) {
      const std::optional<AnswerLine> answer = try_to_ask(body);
      if (!answer || answer->refusal == "CRC") continue;
      if (answer->refusal.empty()) return;
      throw refused(answer->refusal);
    }
    throw Error(device_, "the robot does not answer", "check the cable and the robot's power");
  }

  std::optional<AnswerLine> try_to_ask(const std::string& body) {
    std::unique_lock lock(mutex_);
    if (kind_ == RobotKind::unknown) throw away();
    const int number = next_number();
    answers_.erase(number);
    link_.write(robot_frame(number, body));
    const bool answered = changed_.wait_for(lock, answer_within, [&] { return answers_.contains(number); });
    return answered ? std::optional(answers_.at(number)) : std::nullopt;
  }

  Error refused(const std::string& reason) const {
    if (reason == "FAULT")
      return {device_, "a servo is at fault, and its torque is off",
              "let it cool, remove obstacles, and check its power"};
    if (reason == "HEAT")
      return {device_, "the lamp is too hot, and off", "let it cool down, then switch it on again"};
    if (reason == "BLIND")
      return {device_, "the joint angles are unknown", "check the servos' power and their cable"};
    return {device_, fmt::format("the robot refuses the command ({})", reason),
            "load the firmware of this version of rva (firmware/README.md)"};
  }

  // The state that the robot has sent since the last command.
  std::string next_state() {
    std::unique_lock lock(mutex_);
    const bool answered = changed_.wait_for(
        lock, position_counts, [&] { return state_since_command_ || kind_ == RobotKind::unknown; });
    if (kind_ == RobotKind::unknown) throw away();
    if (!answered)
      throw Error(device_, "the robot sends nothing any more", "check the cable and the robot's power");
    return *state_since_command_;
  }

  // Sends PING regularly, since the robot stops when it receives nothing.
  void keep_in_sight(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (kind() == RobotKind::framed) {
        std::unique_lock lock(mutex_);
        const int number = next_number();
        lock.unlock();
        link_.write(robot_frame(number, "PING"));
      }
      std::this_thread::sleep_for(ping_every);
    }
  }

  int next_number() { return number_ = number_ % 255 + 1; }  // 0 is reserved for answers to damaged frames

  std::string device_;
  mutable std::mutex mutex_;  // guards everything below except asking_, the link and the thread
  std::condition_variable changed_;
  RobotKind kind_ = RobotKind::unknown;
  bool heard_anything_ = false;
  Time opened_at_ = now();
  std::optional<ReadyLine> ready_;
  std::optional<Measured> pan_;
  std::optional<Measured> tilt_;
  std::optional<std::string> state_since_command_;
  Time bare_moved_at_{};
  std::optional<std::vector<int>> found_;
  std::optional<LampState> lamp_;
  Time lamp_at_{};
  std::map<int, AnswerLine> answers_;
  int number_ = 0;
  std::mutex asking_;
  SerialLink link_;
  std::jthread keeper_;
};

SerialRobot::SerialRobot(const std::string& device) : conversation_(std::make_unique<Conversation>(device)) {
  conversation_->wait_until_known();
  conversation_->wait_until_ready();
}

SerialRobot::~SerialRobot() = default;

RobotKind SerialRobot::kind() const { return conversation_->kind(); }
std::string SerialRobot::firmware() const { return conversation_->firmware(); }
RobotLimits SerialRobot::limits() const { return conversation_->limits(); }
void SerialRobot::move_to(const PanTilt& target) { conversation_->move_to(target); }
PanTilt SerialRobot::joints() { return conversation_->joints(); }
bool SerialRobot::moving() { return conversation_->moving(); }
void SerialRobot::stop() { conversation_->stop(); }
std::vector<int> SerialRobot::find_servos() { return conversation_->find_servos(); }
void SerialRobot::name_servo(int from, int to) { conversation_->name_servo(from, to); }
void SerialRobot::turn_to_middle(int id) { conversation_->turn_to_middle(id); }
std::optional<LampState> SerialRobot::lamp() { return conversation_->lamp(); }
void SerialRobot::set_lamp(int percent) { conversation_->set_lamp(percent); }

}  // namespace rva
