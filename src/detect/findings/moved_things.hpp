// Recognises moved objects, which leave two findings: one at the old position, one at the new.
#pragma once

#include <vector>

#include "detect/findings/findings.hpp"
#include "detect/regions/comparison.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Sets `moved_from` of each added finding that has about the size of a removed one: area, length and width
/// on the surface of the object, and height if both have one. Each removed finding is assigned at most once,
/// the most similar pairs first.
///
/// The area is measured in the view, so an object that now lies on another side or is half hidden is not
/// recognised. Equal size is no proof: two objects of one kind have the same size.
/// @param findings   findings of the comparison, with their ids and pixels
void find_moved_things(std::vector<Finding>& findings, const Comparison& comparison,
                       const Intrinsics& camera);

}  // namespace rva
