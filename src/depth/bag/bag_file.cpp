#include "depth/bag/bag_file.hpp"

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
BagFile::BagFile(const std::filesystem::path& path)
    : file_(path), place_(printable(path)), index_(read_bag_index(file_, place_)) {}

std::vector<std::byte> BagFile::read(const RecordedMessage& message) const {
  const RecentChunks::Chunk records =
      chunks_.get(message.at, [&] { return read_chunk(file_, message.at, place_); });
  RosBytes bytes(*records, place_);
  static_cast<void>(bytes.take(message.offset));
  const BagRecord record = take_record(bytes, place_);
  if (record.header.op != BagOp::message)
    throw Error(place_, "its index is damaged", "copy it again, or record it again");
  return {record.data.begin(), record.data.end()};
}

}  // namespace rva
