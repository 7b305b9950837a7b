// What people leave on surfaces: it changes how they look, not where they are.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rva {

enum class TraceKind {
  dust,         ///< a patch as large as a hand, specked
  smear,        ///< of a rag: a stripe of 100 mm by 16 mm
  fingerprint,  ///< an oval of 16 mm by 12 mm with rings
};

/// Makes the surfaces about a point darker or brighter.
struct Trace {
  TraceKind kind = TraceKind::dust;
  Eigen::Vector3f at_m = Eigen::Vector3f::Zero();    ///< world, on a surface
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();  ///< unit: a smear's and a fingerprint's long axis
  float contrast = 0.0F;                             ///< relative, in its middle; above 0 is brighter
};

/// How many of each. Places, directions and contrasts follow from the seed.
struct TraceCounts {
  int dust = 0;
  int smears = 0;
  int fingerprints = 0;
  std::uint64_t seed = 1;

  [[nodiscard]] int all() const { return dust + smears + fingerprints; }
};

}  // namespace rva
