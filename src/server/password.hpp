// Passwords, kept so that nobody can read them back.
#pragma once

#include <string>

namespace rva {

/// Shorter ones are refused.
inline constexpr std::size_t least_password_length = 8;
inline constexpr std::size_t most_password_length = 256;

/// Argon2id with salt, in libsodium's text form. Takes a tenth of a second on purpose.
/// @throws Error when the password is too short or too long
[[nodiscard]] std::string hash_password(const std::string& password);

/// @param hash as hash_password() made it
[[nodiscard]] bool is_password(const std::string& password, const std::string& hash);

/// 32 random bytes of the system's own as 64 hexadecimal digits: nobody guesses it.
[[nodiscard]] std::string random_token();

}  // namespace rva
