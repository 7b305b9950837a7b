#include "stereo/weighted_sums.hpp"

#include "core/vector_clones.hpp"

namespace rva {

RVA_VECTOR_CLONES
void add_weighted(std::int32_t weight, const std::int32_t* from, int count, std::int32_t* sums) {
  for (int i = 0; i < count; ++i) sums[i] += weight * from[i];
}

}  // namespace rva
