#include "robot/lamp.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace rva {

void check_lamp_percent(int percent) {
  if (percent < 0 || percent > 100)
    throw UsageError("lamp", fmt::format("a brightness of {} % is not possible", percent), "give 0 to 100");
}

}  // namespace rva
