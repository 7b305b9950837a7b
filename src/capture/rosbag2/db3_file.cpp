#include "capture/rosbag2/db3_file.hpp"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <span>
#include <string_view>

#include "capture/file_kind.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

// The messages of cameras are smaller than this, compressed or not.
constexpr int max_message_bytes = 128 << 20;

Error damaged(const std::string& source, const std::string& how) {
  return {source, "the recording is damaged: " + how, "copy it again, or record it again"};
}

bool is_beside(const std::filesystem::path& path, std::string_view ending) {
  std::error_code absent;
  const auto bytes = std::filesystem::file_size(path.string() + std::string(ending), absent);
  return !absent && bytes > 0;
}

// The write-ahead log of a killed recorder: what was not yet moved into the file. SQLite reads both as one.
bool has_a_log(const std::filesystem::path& path) { return is_beside(path, "-wal"); }

// The rollback journal of an unfinished change, which only a writer could undo.
bool has_a_journal(const std::filesystem::path& path) { return is_beside(path, "-journal"); }

// A file without a write-ahead log is opened as immutable: SQLite then neither locks it nor writes anything
// beside it. With a log, SQLite writes the log's index and nothing else.
std::string address_of(const std::filesystem::path& path) {
  std::string address = "file:";
  for (const char letter : path.string()) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) != 0 || letter == '/' || letter == '.' || letter == '-' || letter == '_')
      address += letter;
    else
      address += fmt::format("%{:02X}", byte);
  }
  return address + (has_a_log(path) ? "?mode=ro" : "?immutable=1");
}

SQLite::Database open(const std::filesystem::path& path) {
  try {
    SQLite::Database database(address_of(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    // The file may come from an untrusted source.
    sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_limit(database.getHandle(), SQLITE_LIMIT_LENGTH, max_message_bytes);
    return database;
  } catch (const SQLite::Exception& failure) {
    throw Error(printable(path), fmt::format("cannot be read: {}", printable(failure.what())),
                "check its permissions");
  }
}

// Whether the last page is incomplete: SQLite would read the missing part as zeros.
bool ends_within_a_page(SQLite::Database& database, const std::filesystem::path& path) {
  SQLite::Statement page(database, "pragma page_size");
  page.executeStep();
  return std::filesystem::file_size(path) % page.getColumn(0).getUInt() != 0;
}

// Requires tables, since a view in a malicious file could compute for ever.
void require_tables(SQLite::Database& database, const std::string& source) {
  SQLite::Statement tables(database,
                           "select count(*) from sqlite_master where type = 'table' and rootpage > 0 and "
                           "name in ('topics', 'messages')");
  tables.executeStep();
  if (tables.getColumn(0).getInt() != 2)
    throw Error(source, "a database, but not a rosbag2 recording: it has no tables topics and messages",
                "give a .db3 that realsense-viewer recorded");
}

bool is_packed(std::span<const std::byte> bytes) {
  constexpr std::array magic{std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f}, std::byte{0xfd}};
  return bytes.size() >= magic.size() && std::ranges::equal(bytes.first(magic.size()), magic);
}

std::vector<std::byte> unpack(std::span<const std::byte> packed, const std::string& source) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  // The largest values are error codes: unknown size and malformed data.
  if (size > max_message_bytes) throw damaged(source, "a message cannot be decompressed");
  std::vector<std::byte> unpacked(size);
  const std::size_t done = ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
  if (ZSTD_isError(done) != 0 || done != unpacked.size())
    throw damaged(source, "a message cannot be decompressed");
  return unpacked;
}

}  // namespace

bool is_db3_file(const std::filesystem::path& path) {
  constexpr std::string_view magic("SQLite format 3\0", 16);
  return begins_with(path, magic);
}

Db3File::Db3File(const std::filesystem::path& path) : source_(printable(path)), database_(open(path)) {
  try {
    require_tables(database_, source_);
    whole_ = !has_a_journal(path) && !ends_within_a_page(database_, path);
    find_messages();
  } catch (const SQLite::Exception& failure) {
    throw damaged(source_, printable(failure.what()));
  }
}

void Db3File::find_messages() {
  std::map<std::int64_t, RecordedTopic*> by_number;
  SQLite::Statement topics(database_, "select id, name, type from topics where serialization_format = 'cdr'");
  while (topics.executeStep()) {
    RecordedTopic& topic = topics_[topics.getColumn(1).getString()];
    topic.type = topics.getColumn(2).getString();
    by_number[topics.getColumn(0).getInt64()] = &topic;
  }
  try {
    SQLite::Statement messages(database_, "select id, topic_id, timestamp from messages");
    while (messages.executeStep()) {
      throw_if_interrupted();
      const auto topic = by_number.find(messages.getColumn(1).getInt64());
      if (topic == by_number.end()) continue;
      // Messages from before the start of the recording have the lowest possible time.
      const std::int64_t time_ns = std::max<std::int64_t>(0, messages.getColumn(2).getInt64());
      topic->second->messages.push_back({.time_ns = static_cast<std::uint64_t>(time_ns),
                                         .at = static_cast<std::uint64_t>(messages.getColumn(0).getInt64())});
    }
  } catch (const SQLite::Exception&) {
    whole_ = false;
  }
  for (auto& [name, topic] : topics_) std::ranges::stable_sort(topic.messages, {}, &RecordedMessage::time_ns);
}

std::vector<std::byte> Db3File::read(const RecordedMessage& message) const {
  std::vector<std::byte> bytes;
  try {
    const std::lock_guard lock(mutex_);
    SQLite::Statement query(database_, "select data from messages where id = ?");
    query.bind(1, static_cast<std::int64_t>(message.at));
    if (!query.executeStep()) throw damaged(source_, "a message is missing");
    const SQLite::Column data = query.getColumn(0);
    const auto* first = static_cast<const std::byte*>(data.getBlob());
    bytes.assign(first, first + data.getBytes());
  } catch (const SQLite::Exception& failure) {
    throw damaged(source_, printable(failure.what()));
  }
  return is_packed(bytes) ? unpack(bytes, source_) : bytes;
}

}  // namespace rva
