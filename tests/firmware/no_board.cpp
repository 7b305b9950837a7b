#include "tests/firmware/board.hpp"

namespace rva::test {

std::unique_ptr<Firmware> simulated_board() { return nullptr; }

std::optional<BuiltSize> built_size() { return std::nullopt; }

}  // namespace rva::test
