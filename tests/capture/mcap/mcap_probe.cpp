// Prints what our reader finds in an MCAP file, one message a line: topic, type, encoding, time and bytes.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "capture/mcap/mcap_index.hpp"
#include "capture/mcap/mcap_record.hpp"

namespace {

std::string hexadecimal(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += fmt::format("{:02x}", static_cast<unsigned>(byte));
  return text;
}

void print_messages(const std::string& path) {
  const rva::OpenFile file(path);
  const rva::McapIndex index = rva::read_mcap_index(file, path);
  for (const auto& [name, topic] : index.topics) {
    for (const rva::RecordedMessage& message : topic.messages) {
      const std::vector<std::byte> records = rva::read_mcap_records(file, message.at, path);
      rva::RosBytes bytes(std::span<const std::byte>(records).subspan(message.offset), path);
      const rva::McapMessage content =
          rva::parse_mcap_message(rva::take_mcap_record(bytes, path).content, path);
      fmt::print("{} {} {} {} {}\n", name, topic.type.empty() ? "-" : topic.type, index.encodings.at(name),
                 content.time_ns, hexadecimal(content.data));
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    for (int i = 1; i < count; ++i) print_messages(arguments[i]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
