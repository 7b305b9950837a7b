#include "depth/bag/bag_file.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

// A frame, its metadata and its neighbour's lie in one or two.
constexpr std::size_t most_recent_chunks = 8;

}  // namespace

BagFile::BagFile(const std::filesystem::path& path)
    : file_(path), place_(printable(path)), index_(read_bag_index(file_, place_)) {}

BagFile::Chunk BagFile::chunk(std::uint64_t at) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find(recent_chunks_, at, &std::pair<std::uint64_t, Chunk>::first);
    if (known != recent_chunks_.end()) return known->second;
  }
  auto unpacked = std::make_shared<const std::vector<std::byte>>(read_chunk(file_, at, place_));
  const std::lock_guard lock(mutex_);
  recent_chunks_.emplace_front(at, unpacked);
  if (recent_chunks_.size() > most_recent_chunks) recent_chunks_.pop_back();
  return unpacked;
}

std::vector<std::byte> BagFile::read(const RecordedMessage& message) const {
  const Chunk records = chunk(message.at);
  RosBytes bytes(*records, place_);
  static_cast<void>(bytes.take(message.offset));
  const BagRecord record = take_record(bytes, place_);
  if (record.header.op != BagOp::message)
    throw Error(place_, "its index is damaged", "copy it again, or record anew");
  return {record.data.begin(), record.data.end()};
}

}  // namespace rva
