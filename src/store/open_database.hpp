// Opens the database file of SqliteRecords.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"

namespace rva {

/// Opens or creates a file with the tables of schema.hpp. Files of earlier versions are brought up to date.
/// @throws Error when the file cannot be opened or created, belongs to another program, or was written by a
///         newer version of this one
[[nodiscard]] SQLite::Database open_database(const std::filesystem::path& file);

/// Opens a file that is open already (open_database()) once more, for reading: a long query there does not
/// delay changes.
[[nodiscard]] SQLite::Database open_for_reading(const std::filesystem::path& file);

/// A failure of SQLite as an error for the user, without SQLite's own message, which names tables and
/// columns.
/// @param source the file
[[nodiscard]] Error database_error(const std::string& source, const SQLite::Exception& failure);

}  // namespace rva
