#include "audit/key_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "audit/digest.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "rva-signing-key";
constexpr const char* use_backup = "restore it from a backup, or make a new key";
constexpr PasswordCost least_cost{1, std::size_t{8} << 10U};
constexpr PasswordCost most_cost{20, std::size_t{1} << 30U};
using Salt = std::array<unsigned char, crypto_pwhash_SALTBYTES>;
using Nonce = std::array<unsigned char, crypto_secretbox_NONCEBYTES>;

/// The content of a private key's file.
struct KeyFile {
  PublicKey public_key;
  bool encrypted = false;
  PasswordCost cost;
  std::string salt;
  std::string nonce;
  std::string secret;  // the seed, or its ciphertext with the authenticator before it
};

Json json_of(const KeyFile& content) {
  Json json{{"format", format_name}, {"version", 1}, {"public_key", verifier_key(content.public_key)}};
  if (content.encrypted) {
    json["argon2id"] = {{"operations", content.cost.operations},
                        {"memory_bytes", content.cost.memory_bytes},
                        {"salt", base64_of(content.salt)}};
    json["xsalsa20_poly1305"] = {{"nonce", base64_of(content.nonce)},
                                 {"ciphertext", base64_of(content.secret)}};
  } else {
    json["seed"] = base64_of(content.secret);
  }
  return json;
}

// A checksum, so that damage is not mistaken for a wrong password.
std::string text_of(const KeyFile& content) {
  Json json = json_of(content);
  json["sha256"] = hex_of(bytes_of(sha256(json_text(json))));
  return json_file_text(json);
}

Error damaged(const fs::path& file) {
  return {printable(file), "is not a private key of rva, or it is damaged", use_backup};
}

KeyFile content_from(const std::string& text, const fs::path& file) {
  const nlohmann::json json = parse_json(text, printable(file));
  const JsonObject object(json, printable(file));
  KeyFile content;
  const auto bytes = [&](const JsonObject& from, const char* key) {
    std::optional<std::string> decoded = bytes_from_base64(from.string(key));
    if (!decoded) throw damaged(file);
    return *std::move(decoded);
  };
  content.public_key = public_key_from(object.string("public_key"), object.name_of("public_key"));
  content.encrypted = !object.has("seed");
  if (content.encrypted) {
    const JsonObject derivation = object.object("argon2id");
    const JsonObject box = object.object("xsalsa20_poly1305");
    content.cost.operations = static_cast<std::uint64_t>(std::max(0, derivation.integer("operations")));
    content.cost.memory_bytes = static_cast<std::size_t>(std::max(0, derivation.integer("memory_bytes")));
    content.salt = bytes(derivation, "salt");
    content.nonce = bytes(box, "nonce");
    content.secret = bytes(box, "ciphertext");
  } else {
    content.secret = bytes(object, "seed");
  }
  const bool costs = content.cost.operations >= least_cost.operations &&
                     content.cost.operations <= most_cost.operations &&
                     content.cost.memory_bytes >= least_cost.memory_bytes &&
                     content.cost.memory_bytes <= most_cost.memory_bytes;
  if (!costs || text_of(content) != text) throw damaged(file);
  return content;
}

KeyFile read_key_file(const fs::path& file) {
  const std::string text = read_text_file(file);
  if (text.find(format_name) == text.npos && text.find('+') != text.npos && text.find('{') == text.npos)
    throw Error(printable(file), "is a public key", "give the private key, the file without .pub");
  try {
    return content_from(text, file);
  } catch (const Error&) {
    throw damaged(file);
  }
}

/// The key that encrypts the seed, wiped after use.
class BoxKey {
 public:
  BoxKey(const std::string& password, const std::string& salt, const PasswordCost& cost) {
    if (crypto_pwhash(key_.data(), key_.size(), password.data(), password.size(),
                      reinterpret_cast<const unsigned char*>(salt.data()), cost.operations, cost.memory_bytes,
                      crypto_pwhash_ALG_ARGON2ID13) != 0)
      throw Error("password", "there is not enough memory to derive the key from it", "close other programs");
  }
  ~BoxKey() { sodium_memzero(key_.data(), key_.size()); }
  BoxKey(const BoxKey&) = delete;
  BoxKey& operator=(const BoxKey&) = delete;
  [[nodiscard]] const unsigned char* data() const { return key_.data(); }

 private:
  std::array<unsigned char, crypto_secretbox_KEYBYTES> key_{};
};

template <typename Array>
std::string random_bytes() {
  Array bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return std::string(bytes_of(bytes));
}

KeyFile encrypted(const SigningKey& key, const std::string& password, const PasswordCost& cost) {
  if (password.size() < least_key_password_bytes || password.size() > most_key_password_bytes)
    throw Error("password", fmt::format("has {} characters", password.size()),
                fmt::format("give {} to {}", least_key_password_bytes, most_key_password_bytes));
  KeyFile content{key.public_key(), true, cost, random_bytes<Salt>(), random_bytes<Nonce>(), {}};
  content.secret.resize(crypto_secretbox_MACBYTES + key.seed().size());
  const BoxKey box(password, content.salt, cost);
  crypto_secretbox_easy(reinterpret_cast<unsigned char*>(content.secret.data()), key.seed().data(),
                        key.seed().size(), reinterpret_cast<const unsigned char*>(content.nonce.data()),
                        box.data());
  return content;
}

// The seed of an encrypted file; empty where the password is wrong.
std::optional<std::string> decrypted(const KeyFile& content, const std::string& password) {
  const BoxKey box(password, content.salt, content.cost);
  std::string seed(content.secret.size() - crypto_secretbox_MACBYTES, '\0');
  if (crypto_secretbox_open_easy(
          reinterpret_cast<unsigned char*>(seed.data()),
          reinterpret_cast<const unsigned char*>(content.secret.data()), content.secret.size(),
          reinterpret_cast<const unsigned char*>(content.nonce.data()), box.data()) != 0)
    return std::nullopt;
  return seed;
}

bool has_right_sizes(const KeyFile& content) {
  if (!content.encrypted) return content.secret.size() == crypto_sign_SEEDBYTES;
  return content.secret.size() == crypto_secretbox_MACBYTES + crypto_sign_SEEDBYTES &&
         content.salt.size() == crypto_pwhash_SALTBYTES &&
         content.nonce.size() == crypto_secretbox_NONCEBYTES;
}

// Nobody else may read the file, not even while it is written.
void write_private(const fs::path& file, const std::string& text) {
  replace_file(file, [&](const fs::path& partial) {
    const int descriptor = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor >= 0) ::close(descriptor);  // write_file() reports why it could not be created
    write_file(partial, text);
  });
}

void require_absent(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored)))
    throw Error(printable(file), "already exists, and keys are never replaced", "choose another name");
}

}  // namespace

fs::path public_file_of(const fs::path& file) { return file.native() + ".pub"; }

void write_key_files(const fs::path& file, const SigningKey& key, const std::optional<std::string>& password,
                     const PasswordCost& cost) {
  require_absent(file);
  require_absent(public_file_of(file));
  const KeyFile plain{key.public_key(), false, {}, {}, {}, std::string(bytes_of(key.seed()))};
  const KeyFile content = password ? encrypted(key, *password, cost) : plain;
  write_private(file, text_of(content));
  try {
    replace_file(public_file_of(file), verifier_key(key.public_key()) + '\n');
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
}

SigningKey read_signing_key(const fs::path& file, const AsksPassword& ask) {
  const KeyFile content = read_key_file(file);
  if (!has_right_sizes(content)) throw damaged(file);
  const std::optional<std::string> secret =
      content.encrypted ? decrypted(content, ask(content.public_key, file)) : content.secret;
  if (!secret)
    throw WrongKeyPassword(printable(file), "is not opened by this password",
                           "enter the password of " + content.public_key.name + " again");
  SigningKey::Seed seed{};
  std::copy(secret->begin(), secret->end(), seed.begin());
  SigningKey key(content.public_key.name, seed);
  if (key.public_key() != content.public_key) throw damaged(file);
  return key;
}

PublicKey read_public_key(const fs::path& file) {
  const std::string text = read_text_file(file);
  if (text.find(format_name) != text.npos) return read_key_file(file).public_key;
  const std::size_t end = text.find_last_not_of("\r\n");
  return public_key_from(std::string_view(text).substr(0, end == text.npos ? 0 : end + 1), printable(file));
}

}  // namespace rva
