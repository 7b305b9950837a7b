// A data folder after whatever stopped the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "inspect/records.hpp"

namespace rva {

/// Removes captures and results that were not complete when the program was killed, and comparisons that were
/// begun and never recorded; restores earlier captures that a former version of the program had moved aside.
/// What is complete, recorded or of somebody else stays; what the records do not have is named. To be called
/// before anything else uses the folder.
/// @param data the folder, which no other program uses
/// @return what was done, a sentence for each path, for a person
/// @throws Error when the records cannot be read
std::vector<std::string> recover_data(const std::filesystem::path& data, const Records& records);

}  // namespace rva
