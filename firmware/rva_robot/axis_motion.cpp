#include "axis_motion.h"

#include <stdlib.h>

#include "motion.h"

namespace rva_robot {
namespace {

constexpr uint8_t most_tries = 5;
constexpr uint8_t settles_within_ms = 150;
constexpr uint8_t stops_within_ms = 40;
constexpr int16_t arrived_cdeg = 66;  // two counts
// Maximum age of a position on which a decision is based, since the axis may have moved since.
constexpr uint8_t fresh_ms = 60;
constexpr uint8_t on_the_line_ms = 10;

uint16_t distance_cdeg(int16_t from, int16_t to) {
  return static_cast<uint16_t>(abs(static_cast<int32_t>(to) - from));
}

}  // namespace

void AxisMotion::start(int16_t target_cdeg, int16_t speed_cdeg_s) {
  target_cdeg_ = target_cdeg;
  speed_cdeg_s_ = speed_cdeg_s;
  tries_ = 0;
  phase_ = Phase::due;
}

void AxisMotion::stop(uint32_t now_ms) {
  phase_ = Phase::stopping;
  tries_ = 0;
  sent_ms_ = now_ms - stops_within_ms;  // so that the first stop is sent at once
}

void AxisMotion::forget() { phase_ = Phase::rest; }

void AxisMotion::tick(ServoBus& bus, uint8_t axis, uint32_t now_ms) {
  if (phase_ == Phase::under_way) follow(bus.servo(axis), now_ms);
  if (phase_ == Phase::due) send_piece(bus, axis, now_ms);
  if (phase_ == Phase::stopping) see_it_stop(bus, axis, now_ms);
}

// Sends the next piece of a move. While the axis moves, its position is uncertain; the play time is chosen so
// that the speed limit is kept for any position that the axis may have reached.
void AxisMotion::send_piece(ServoBus& bus, uint8_t axis, uint32_t now_ms) {
  const Servo& servo = bus.servo(axis);
  if (!servo.known(now_ms, fresh_ms)) return;
  uint16_t unsure_cdeg = 0;
  if ((servo.detail & herkulex::moving) != 0) {
    const uint32_t age_ms = now_ms - servo.measured_ms + on_the_line_ms;
    unsure_cdeg = static_cast<uint16_t>(age_ms * static_cast<uint32_t>(fastest_cdeg_s) / 1000);
  }
  const uint16_t far_cdeg = farthest_cdeg(speed_cdeg_s_);
  if (2 * unsure_cdeg > far_cdeg) {  // too fast for the new speed limit, so the axis stops first
    if (now_ms - sent_ms_ >= stops_within_ms && bus.stop(axis)) sent_ms_ = now_ms;
    return;
  }
  uint16_t piece_cdeg = distance_cdeg(servo.cdeg, target_cdeg_);
  piece_cdeg_ = target_cdeg_;
  if (piece_cdeg + unsure_cdeg > far_cdeg) {
    piece_cdeg = static_cast<uint16_t>(far_cdeg - unsure_cdeg);
    piece_cdeg_ =
        static_cast<int16_t>(target_cdeg_ > servo.cdeg ? servo.cdeg + piece_cdeg : servo.cdeg - piece_cdeg);
  }
  // One count (33 cdeg) is added, since the servo rounds positions by up to that much.
  const uint16_t play = play_of(static_cast<uint16_t>(piece_cdeg + unsure_cdeg + 33), speed_cdeg_s_);
  const uint8_t sendable =
      static_cast<uint8_t>(play > herkulex::longest_play ? herkulex::longest_play : play);
  if (!bus.move(axis, piece_cdeg_, sendable)) return;
  sent_ms_ = now_ms;
  takes_ms_ = ms_of_play(sendable);
  phase_ = Phase::under_way;
}

void AxisMotion::follow(const Servo& servo, uint32_t now_ms) {
  const uint32_t since_ms = now_ms - sent_ms_;
  if (since_ms < takes_ms_ || !servo.known(now_ms, fresh_ms)) return;
  const uint32_t age_ms = now_ms - servo.measured_ms;
  if (age_ms > since_ms - takes_ms_) return;  // measured before the piece was due to end
  const bool arrived = distance_cdeg(servo.cdeg, piece_cdeg_) <= arrived_cdeg;
  if (arrived && piece_cdeg_ == target_cdeg_) {
    phase_ = Phase::rest;
  } else if (arrived) {
    tries_ = 0;
    phase_ = Phase::due;
  } else if (since_ms >= static_cast<uint32_t>(takes_ms_) + settles_within_ms) {
    phase_ = ++tries_ < most_tries ? Phase::due : Phase::rest;
  }
}

void AxisMotion::see_it_stop(ServoBus& bus, uint8_t axis, uint32_t now_ms) {
  const uint32_t since_ms = now_ms - sent_ms_;
  if (since_ms < stops_within_ms) return;
  const Servo& servo = bus.servo(axis);
  const bool seen_since = tries_ > 0 && servo.answered && now_ms - servo.measured_ms < since_ms;
  if (seen_since && (servo.detail & herkulex::moving) == 0) {
    phase_ = Phase::rest;
    return;
  }
  if (!bus.stop(axis)) return;
  sent_ms_ = now_ms;
  if (tries_ < UINT8_MAX) ++tries_;
}

}  // namespace rva_robot
