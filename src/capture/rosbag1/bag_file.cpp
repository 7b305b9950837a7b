#include "capture/rosbag1/bag_file.hpp"

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
BagFile::BagFile(const std::filesystem::path& path)
    : file_(path), source_(printable(path)), index_(read_bag_index(file_, source_)) {}

std::vector<std::byte> BagFile::read(const RecordedMessage& message) const {
  const RecentChunks::Chunk records =
      chunks_.get(message.at, [&] { return read_chunk(file_, message.at, source_); });
  RosBytes bytes(*records, source_);
  static_cast<void>(bytes.take(message.offset));
  const BagRecord record = take_record(bytes, source_);
  if (record.header.op != BagOp::message)
    throw Error(source_, "its index is damaged", "copy it again, or record it again");
  return {record.data.begin(), record.data.end()};
}

}  // namespace rva
