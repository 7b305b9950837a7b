// The shapes of the debris catalogue. Lengths in this header are in millimetres, as in drawings;
// make_debris() converts them to metres.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "scene/scene.hpp"
#include "scene/solids/extrusion.hpp"

namespace rva {

/// The parts of an object, each of one material.
using Parts = std::vector<Part>;

/// A part of one material.
/// @param material name from material_names()
[[nodiscard]] Part part_of(std::string_view material, TriangleMesh mesh);

/// The mesh shifted by a vector.
[[nodiscard]] TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& by);

/// The mesh scaled along each axis by a positive factor.
[[nodiscard]] TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& factors);
/// The mesh rotated counterclockwise about an axis of unit length.
[[nodiscard]] TriangleMesh turned(const TriangleMesh& mesh, double angle_deg, const Eigen::Vector3d& axis);
/// lathe() for a profile given as a list: corners (r, z).
[[nodiscard]] TriangleMesh turned_solid(std::initializer_list<Eigen::Vector2d> profile_rz, int segments);
/// turned_ring() for a loop given as a list: corners (r, z), up along the outside, down along the bore.
[[nodiscard]] TriangleMesh turned_hollow(std::initializer_list<Eigen::Vector2d> loop_rz, int segments);
/// The corners of a regular hexagon.
/// @param across_flats distance between opposite sides
[[nodiscard]] Outline hexagon(double across_flats);
/// An arc, both ends included, counterclockwise.
[[nodiscard]] Outline arc(const Eigen::Vector2d& center, double radius, double from_deg, double to_deg,
                          int pieces);
/// A strip of sheet metal or tape along a path.
/// @param normals directions of its thickness, one for each point of the path, of unit length
/// @param across  direction of its width, of unit length
[[nodiscard]] TriangleMesh ribbon(const std::vector<Eigen::Vector3d>& path,
                                  const std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& across,
                                  double width, double thickness);
/// The parts, uniformly scaled to the given largest extent, so that random shapes of a kind have one size.
[[nodiscard]] Parts fitted(Parts parts, double largest_extent);

/// Tools and the contents of pockets.
[[nodiscard]] Parts flashlight();

/// A one-cell torch.
[[nodiscard]] Parts small_flashlight();

/// A screwdriver with a blade of ISO 8764 PH2.
[[nodiscard]] Parts screwdriver();

/// A socket for 17 mm, DIN 3124.
[[nodiscard]] Parts socket();

/// A combination wrench for 13 mm, DIN 3113.
[[nodiscard]] Parts wrench();

/// A twist drill, DIN 338.
/// @param flute_length part of the length that has flutes
[[nodiscard]] Parts drill_bit(double diameter, double length, double flute_length);

/// A temporary fastener that clamps sheets through their rivet holes.
[[nodiscard]] Parts sheet_holder();

/// A ball-point pen with its cap.
[[nodiscard]] Parts pen();

/// A house key.
[[nodiscard]] Parts key();

/// Fasteners of a wing.
[[nodiscard]] Parts swaged_collar(double diameter_in);

/// A bolt M6 x 30, ISO 4014.
[[nodiscard]] Parts bolt_m6();

/// A shear pin with a flat head, 3/16 in.
[[nodiscard]] Parts hi_lok();

/// A nut M6, ISO 4032.
[[nodiscard]] Parts nut_m6();

/// An anchor nut with two rivet holes, MS21047.
[[nodiscard]] Parts nut_plate();

/// A solid rivet with a universal head, MS20470.
[[nodiscard]] Parts rivet();

/// A washer M6, ISO 7089.
[[nodiscard]] Parts washer_m6();

/// Flexible objects, of random shape except for the roll of tape.
[[nodiscard]] Parts swarf(Random& random);

/// A piece of insulated wire.
[[nodiscard]] Parts wire(Random& random);

/// A roll of masking tape.
[[nodiscard]] Parts tape_roll();

/// A curled strip of masking tape.
[[nodiscard]] Parts tape_strip(Random& random);

/// A crumpled workshop cloth.
[[nodiscard]] Parts rag(Random& random);

/// A work glove.
[[nodiscard]] Parts glove(Random& random);

/// Objects outside the catalogue. One to three boxes, cylinders, tubes or cones of random sizes, 8 to 200 mm
/// overall, in random directions and materials.
[[nodiscard]] Parts random_shape(Random& random);

/// A spray can of 400 ml.
[[nodiscard]] Parts spray_can();

/// A tape measure of 5 m in its case.
[[nodiscard]] Parts tape_measure();

/// Combination pliers of 165 mm.
[[nodiscard]] Parts pliers();

/// A battery of size D.
[[nodiscard]] Parts battery();

/// A paper cup of 200 ml.
[[nodiscard]] Parts paper_cup();

/// A hexagon key of 6 mm, ISO 2936.
[[nodiscard]] Parts hex_key();

/// An inspection mirror with its rod.
[[nodiscard]] Parts mirror();

/// A flat paint brush, 40 mm wide.
[[nodiscard]] Parts paint_brush();

/// A worm-drive hose clamp for 40 mm.
[[nodiscard]] Parts hose_clamp();

/// A protective cap of a hydraulic fitting.
[[nodiscard]] Parts protective_cap();

}  // namespace rva
