// Traces that people leave on surfaces, which change their brightness but not their shape.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rva {

/// The kinds of traces, with their sizes.
enum class TraceKind {
  dust,         ///< a speckled patch of the size of a hand
  smear,        ///< from a rag: a stripe of 100 mm by 16 mm
  fingerprint,  ///< an oval of 16 mm by 12 mm with rings
};

/// Makes the surfaces around a point darker or brighter.
struct Trace {
  TraceKind kind = TraceKind::dust;                  ///< shape and size
  Eigen::Vector3f at_m = Eigen::Vector3f::Zero();    ///< world, on a surface
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();  ///< unit vector: long axis of a smear or fingerprint
  float contrast = 0.0F;                             ///< relative, at its centre; above 0 is brighter
};

/// The number of traces of each kind. Positions, directions and contrasts follow from the seed.
struct TraceCounts {
  int dust = 0;            ///< patches of dust
  int smears = 0;          ///< smears from a rag
  int fingerprints = 0;    ///< fingerprints
  std::uint64_t seed = 1;  ///< determines positions, directions and contrasts

  /// Number of all traces.
  [[nodiscard]] int all() const { return dust + smears + fingerprints; }
};

}  // namespace rva
