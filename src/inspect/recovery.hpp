// Repairs a data folder after the program was stopped at an arbitrary moment.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "inspect/records.hpp"

namespace rva {

/// Removes captures, results and pictures that were incomplete when the program was killed, and comparisons
/// that were begun but never recorded; restores captures that an earlier version of the program had moved
/// aside. Files that are complete, recorded or not written by this program stay. What is missing from the
/// records is reported. Call this before anything else uses the folder.
/// @param data the folder; no other program may be using it
/// @return what was done or noticed, one sentence for the user for each path
/// @throws Error when the records cannot be read
std::vector<std::string> recover_data(const std::filesystem::path& data, const Records& records);

}  // namespace rva
