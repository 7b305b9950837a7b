// Hashes of passwords, from which the passwords cannot be recovered.
#pragma once

#include <string>

namespace rva {

/// Limits in bytes; shorter and longer passwords are refused.
inline constexpr std::size_t least_password_length = 8;
inline constexpr std::size_t most_password_length = 256;

/// Argon2id with salt, in libsodium's text form. Deliberately takes a tenth of a second.
/// @throws Error when the password is too short or too long
[[nodiscard]] std::string hash_password(const std::string& password);

/// @param hash as hash_password() made it
[[nodiscard]] bool is_password(const std::string& password, const std::string& hash);

/// 32 random bytes from the operating system, as 64 hexadecimal digits.
[[nodiscard]] std::string random_token();

}  // namespace rva
