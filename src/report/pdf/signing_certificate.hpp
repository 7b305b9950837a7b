// The certificate and private key with which a PDF file is signed.
#pragma once

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rva {

/// A certificate with its private key, RSA of at least 2048 bits or ECDSA on P-256.
struct SigningCertificate {
  std::string source{};                        ///< the file, for messages
  std::shared_ptr<X509> certificate{};         ///< of the key
  std::shared_ptr<EVP_PKEY> key{};             ///< private
  std::vector<std::shared_ptr<X509>> chain{};  ///< of those that issued it, as far as the file has them
};

/// Gives the passphrase of a file.
using AsksPassphrase = std::function<std::string()>;

/// Reads a PKCS#12 file (RFC 7292).
/// @param ask is called once the file is known to be one
/// @throws Error when the file cannot be read, is none, has another passphrase, or has no certificate with a
///         key that can sign a document
[[nodiscard]] SigningCertificate read_signing_certificate(const std::filesystem::path& file,
                                                          const AsksPassphrase& ask);

/// Refuses a certificate that is not valid at a time. @param at ISO 8601 in UTC
/// @throws Error when it has expired or begins later
void require_valid(const SigningCertificate& certificate, const std::string& at);

/// The name of its owner (the common name, or all of the subject), UTF-8.
[[nodiscard]] std::string owner_of(const SigningCertificate& certificate);

}  // namespace rva
