#include "server/password.hpp"

#include <fmt/format.h>
#include <sodium.h>

#include <array>

#include "core/error.hpp"

namespace rva {
namespace {

void require_sodium() {
  if (sodium_init() < 0)
    throw Error("passwords", "the system provides no random numbers", "restart the computer");
}

}  // namespace

std::string hash_password(const std::string& password) {
  require_sodium();
  if (password.size() < least_password_length || password.size() > most_password_length)
    throw Error("password", fmt::format("has {} characters", password.size()),
                fmt::format("give {} to {}", least_password_length, most_password_length));
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                        crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0)
    throw Error("password", "there is not enough memory to hash it", "close other programs");
  return hash.data();
}

bool is_password(const std::string& password, const std::string& hash) {
  require_sodium();
  return password.size() <= most_password_length &&
         crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

std::string random_token() {
  require_sodium();
  std::array<unsigned char, 32> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::array<char, 2 * bytes.size() + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

}  // namespace rva
