// The file of SqliteRecords.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"

namespace rva {

/// Opens or makes a file with the tables of schema.hpp; files of earlier versions are brought up to date.
/// @throws Error when it cannot be opened or made, is no database of ours, or is of a newer version
[[nodiscard]] SQLite::Database open_database(const std::filesystem::path& file);

/// What SQLite refused, in words for a person and without SQLite's own, which name tables and columns.
[[nodiscard]] Error database_error(const std::string& place, const SQLite::Exception& failure);

}  // namespace rva
