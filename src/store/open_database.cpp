#include "store/open_database.hpp"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <system_error>

#include "core/path_text.hpp"
#include "store/schema.hpp"

namespace rva {
namespace {

// Stored in the file as SQLite's application_id, so that the database of another program is refused.
constexpr int our_application = 0x52564131;  // "RVA1"
constexpr int busy_limit_ms = 5000;

void bring_up_to_date(SQLite::Database& database, int version) {
  if (version == schema_version) return;
  SQLite::Transaction transaction(database);
  if (version < 1) database.exec(schema);
  if (version < 2) database.exec(schema_2_from_1);
  if (version < 3) database.exec(schema_3_from_2);
  if (version < 4) database.exec(schema_4_from_3);
  if (version < 5) database.exec(schema_5_from_4);
  if (version < 6) database.exec(schema_6_from_5);
  if (version < 7) database.exec(schema_7_from_6);
  if (version < 8) database.exec(schema_8_from_7);
  database.exec(schema_9_from_8);
  database.exec(fmt::format("pragma application_id = {}", our_application));
  database.exec(fmt::format("pragma user_version = {}", schema_version));
  transaction.commit();
}

}  // namespace

SQLite::Database open_database(const std::filesystem::path& file) {
  const std::string source = printable(file);
  std::error_code ignored;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, ignored)))
    throw Error(source, "is a link, which would lead records out of the data folder",
                "replace it with the file, or use another data folder");
  try {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_limit_ms);
    const int application = database.execAndGet("pragma application_id");
    const int version = database.execAndGet("pragma user_version");
    const int tables = database.execAndGet("select count(*) from sqlite_master");
    if (application != our_application && (application != 0 || tables > 0))
      throw Error(source, "is a database of another program", "use another data folder");
    if (version > schema_version)
      throw Error(source, "was written by a newer version of this program", "use that version");
    database.exec("pragma journal_mode = wal");
    database.exec("pragma synchronous = full");
    bring_up_to_date(database, version);
    database.exec("pragma foreign_keys = on");  // only now: migrations replace tables
    return database;
  } catch (const SQLite::Exception& failure) {
    throw database_error(source, failure);
  }
}

SQLite::Database open_for_reading(const std::filesystem::path& file) {
  return {file.string(), SQLite::OPEN_READONLY, busy_limit_ms};
}

Error database_error(const std::string& source, const SQLite::Exception& failure) {
  switch (failure.getErrorCode()) {
    case SQLITE_FULL:
      return {source, "cannot be written: the disk is full", "free some space, and try again"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {source, "is in use by another program", "wait for it, and try again"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return {source, "cannot be opened or written", "check the folder and the file's permissions"};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return {source, "is damaged or not a database", "restore it from a backup"};
    case SQLITE_IOERR:
      return {source, "cannot be read or written: the disk failed", "check the disk"};
    default:
      return {source,
              fmt::format("cannot be read or changed (database error {})", failure.getExtendedErrorCode()),
              "try again, and report this number if it happens again"};
  }
}

}  // namespace rva
