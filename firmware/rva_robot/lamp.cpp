#include "lamp.h"

namespace rva_robot {
namespace {

constexpr uint8_t read_every_ms = 10;

// Counts at -20, -10, ... 100 degrees: 1023 R / (R + 10 kOhm), R = 10 kOhm exp(3950 K (1 / T - 1 / 298.15
// K)).
constexpr int16_t coldest_dc = -200;
constexpr int16_t step_dc = 100;
constexpr uint16_t counts_at[] = {934, 873, 788, 684, 569, 456, 354, 270, 204, 153, 115, 87, 67};
constexpr uint8_t steps = sizeof counts_at / sizeof *counts_at - 1;

}  // namespace

int16_t heat_of(uint16_t counts) {
  if (counts > counts_at[0]) return no_heat;
  for (uint8_t i = 0; i < steps; ++i) {
    const uint16_t cold = counts_at[i];
    const uint16_t warm = counts_at[i + 1];
    if (counts < warm) continue;
    const int16_t beyond =
        static_cast<int16_t>(static_cast<int32_t>(step_dc) * (cold - counts) / (cold - warm));
    return static_cast<int16_t>(coldest_dc + i * step_dc + beyond);
  }
  return no_heat;
}

bool Lamp::set(uint8_t percent) {
  const bool allowed = percent == 0 || (heat_dc_ != no_heat && !too_hot_);
  percent_ = allowed ? percent : 0;
  port_.drive(static_cast<uint8_t>((percent_ * 255U + 50U) / 100U));
  return allowed;
}

void Lamp::tick(uint32_t now_ms) {
  if (now_ms - read_ms_ < read_every_ms) return;
  read_ms_ = now_ms;
  sum_ = static_cast<uint16_t>(sum_ + port_.thermistor());
  if (++count_ == readings) measured();
}

void Lamp::measured() {
  heat_dc_ = heat_of(static_cast<uint16_t>((sum_ + readings / 2) / readings));
  sum_ = 0;
  count_ = 0;
  const bool known = heat_dc_ != no_heat;
  if (known && heat_dc_ > hottest_dc) too_hot_ = true;
  if (known && heat_dc_ < cool_dc) too_hot_ = false;
  if (percent_ > 0 && (too_hot_ || !known)) (void)set(0);
}

}  // namespace rva_robot
