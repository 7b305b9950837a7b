// The `wing` and `work` sections of a scene file.
#pragma once

#include "core/yaml_node.hpp"
#include "scene/wing/wing_bay.hpp"

namespace rva {

/// Reads the section `wing`. @throws Error also for sizes that do not fit together
[[nodiscard]] WingBay read_wing(const YamlNode& section);

/// Reads the section `work`. @throws Error naming the field
[[nodiscard]] Work read_work(const YamlNode& section);

}  // namespace rva
