// An object that was moved leaves two findings: one where it was, one where it is.
#pragma once

#include <vector>

#include "detect/comparison.hpp"
#include "detect/findings.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Sets `moved_from` of each added finding that has about the size of a removed one: footprint, length and
/// breadth on the object's own surface, and height, as far as both have one. Each removed finding is named
/// once at most, pairs that are most alike first.
///
/// A footprint is measured in the view, so an object that was turned onto another side, or that is half
/// hidden now, is not recognised. Like size is no proof: two objects of one kind look the same.
/// @param findings   of the comparison, with their ids and pixels
void find_moved_things(std::vector<Finding>& findings, const Comparison& comparison,
                       const Intrinsics& camera);

}  // namespace rva
