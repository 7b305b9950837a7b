// Parallel loops over the rows of an image.
#pragma once

#include <functional>

namespace rva {

/// Calls `work(first, end)` for bands that together cover [0, rows), on as many threads as the processor has
/// cores, and returns when all bands have ended. The result of a row must not depend on the band that it is
/// in, so that results do not depend on the machine.
/// @param rows at least 0; with 0, `work` is called once with an empty band
/// @throws the exception of the uppermost band in which `work` threw, after all bands have ended
void parallel_bands(int rows, const std::function<void(int first, int end)>& work);

}  // namespace rva
