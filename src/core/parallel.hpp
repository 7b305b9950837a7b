// Rows of an image, shared out over the processor's cores.
#pragma once

#include <functional>

namespace rva {

/// Calls `work(first, end)` for bands that together cover [0, rows), each on a thread of its own, and waits.
/// What a row gets may not depend on the band it is in, so that results do not depend on the machine.
/// @param rows at least 0
/// @throws what `work` threw in the uppermost band where it did, after all bands have ended
void parallel_bands(int rows, const std::function<void(int first, int end)>& work);

}  // namespace rva
