// Keys in files: the private half as JSON that its owner alone can read, encrypted with a password or plain;
// the public half as one line, a verifier_key(), in a file of the same name with .pub at its end
// (docs/record.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "audit/signing_key.hpp"
#include "core/error.hpp"

namespace rva {

/// Limits of the password of a key, in bytes.
inline constexpr std::size_t least_key_password_bytes = 8;
/// See least_key_password_bytes.
inline constexpr std::size_t most_key_password_bytes = 256;

/// How costly it is to try a password (Argon2id).
struct PasswordCost {
  std::uint64_t operations = 3;                        ///< passes over the memory, 1 to 20
  std::size_t memory_bytes = std::size_t{256} << 20U;  ///< 8 KiB to 1 GiB
};

/// Where the public half of a key is: FILE.pub.
[[nodiscard]] std::filesystem::path public_file_of(const std::filesystem::path& file);

/// Writes both halves, the private one with mode 0600 and encrypted if there is a password. Each file appears
/// whole; if the program is stopped between them, the private one contains the public key, too.
/// @throws Error when either file exists, the password is too short or too long, or the disk refuses
void write_key_files(const std::filesystem::path& file, const SigningKey& key,
                     const std::optional<std::string>& password, const PasswordCost& cost = {});

/// The password does not open the file.
class WrongKeyPassword : public Error {
 public:
  using Error::Error;
};

/// Asks for the password of a key, whose verifier name and file a message may state.
using AsksPassword = std::function<std::string(const PublicKey& key, const std::filesystem::path& file)>;

/// Reads a private key, and asks for the password only if the file is encrypted and whole.
/// @throws Error when the file is missing, damaged or a public key; WrongKeyPassword
[[nodiscard]] SigningKey read_signing_key(const std::filesystem::path& file, const AsksPassword& ask);

/// Reads the public key of either half's file; that of a private key needs no password.
/// @throws Error when the file is missing, damaged or no key
[[nodiscard]] PublicKey read_public_key(const std::filesystem::path& file);

}  // namespace rva
