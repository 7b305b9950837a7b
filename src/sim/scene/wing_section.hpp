// The `wing` and `work` sections of a scene file.
#pragma once

#include "sim/scene/wing_bay.hpp"
#include "sim/scene/yaml_node.hpp"

namespace rva {

/// @throws Error also for sizes that do not fit together
[[nodiscard]] WingBay read_wing(const YamlNode& section);
[[nodiscard]] Work read_work(const YamlNode& section);

}  // namespace rva
