// Mutates PNG files so that they get past the decoder's checksums, which would refuse nearly every one.
#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cstddef>
#include <cstdint>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

constexpr std::size_t signature_bytes = 8;
constexpr std::size_t word = 4;

// A chunk is length, type, content, checksum of type and content (PNG specification, 5.3).
void mend_checksums(std::uint8_t* data, std::size_t size) {
  for (std::size_t at = signature_bytes; size >= 3 * word && at <= size - 3 * word;) {
    const std::size_t length = boost::endian::load_big_u32(data + at);
    const std::size_t room = size - at - 3 * word;
    if (length > room) return;
    boost::crc_32_type checksum;
    checksum.process_bytes(data + at + word, word + length);
    boost::endian::store_big_u32(data + at + 2 * word + length, checksum.checksum());
    at += 3 * word + length;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  size = LLVMFuzzerMutate(data, size, max_size);
  const bool png = size > signature_bytes && data[0] == 0x89;
  const bool leave_damaged = seed % 8 == 0;
  if (png && !leave_damaged) mend_checksums(data, size);
  return size;
}
