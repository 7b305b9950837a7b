#include "report/pdf/signing_certificate.hpp"

#include <fmt/format.h>
#include <openssl/pkcs12.h>
#include <openssl/x509v3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string_view>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* other_file = "give a PKCS#12 file (.p12, .pfx) with a certificate and its private key";

using Pkcs12 = std::unique_ptr<PKCS12, decltype(&PKCS12_free)>;

Pkcs12 pkcs12_of(const fs::path& file) {
  const std::vector<std::byte> bytes = read_file(file);
  const auto* at = reinterpret_cast<const unsigned char*>(bytes.data());
  Pkcs12 read(d2i_PKCS12(nullptr, &at, static_cast<long>(bytes.size())), PKCS12_free);
  if (!read) throw Error(printable(file), "is no PKCS#12 file", other_file);
  return read;
}

// An empty passphrase and none are different for some programs that write these files.
void require_digest(PKCS12* read, const fs::path& file, const std::string& passphrase) {
  if (PKCS12_mac_present(read) == 0 || PKCS12_verify_mac(read, passphrase.c_str(), -1) == 1) return;
  if (passphrase.empty() && PKCS12_verify_mac(read, nullptr, 0) == 1) return;
  throw Error(printable(file), "cannot be opened with this passphrase", "give the passphrase of the file");
}

bool is_fit(EVP_PKEY* key) {
  constexpr int least_rsa_bits = 2048;
  if (EVP_PKEY_is_a(key, "RSA") == 1) return EVP_PKEY_get_bits(key) >= least_rsa_bits;
  std::array<char, 32> curve{};
  return EVP_PKEY_is_a(key, "EC") == 1 &&
         EVP_PKEY_get_group_name(key, curve.data(), curve.size(), nullptr) == 1 &&
         (std::string_view(curve.data()) == "prime256v1" || std::string_view(curve.data()) == "P-256");
}

void require_fit(const SigningCertificate& read) {
  if (!read.certificate || !read.key)
    throw Error(read.source, "contains no certificate with its private key", other_file);
  if (!is_fit(read.key.get()))
    throw Error(read.source, "has a key that is neither RSA of at least 2048 bits nor ECDSA on P-256",
                "use a certificate with such a key");
  constexpr std::uint32_t signs = KU_DIGITAL_SIGNATURE | KU_NON_REPUDIATION;
  if ((X509_get_key_usage(read.certificate.get()) & signs) == 0)
    throw Error(read.source, "has a certificate that is not meant for signatures",
                "use one whose key usage is digital signature or non-repudiation");
}

std::string date_text(const ASN1_TIME* stated) {
  constexpr int tm_epoch = 1900;
  std::tm time{};
  if (ASN1_TIME_to_tm(stated, &time) != 1) return "an unreadable date";
  return fmt::format("{:04}-{:02}-{:02}", time.tm_year + tm_epoch, time.tm_mon + 1, time.tm_mday);
}

}  // namespace

SigningCertificate read_signing_certificate(const fs::path& file, const AsksPassphrase& ask) {
  const Pkcs12 read = pkcs12_of(file);
  const std::string passphrase = ask();
  require_digest(read.get(), file, passphrase);
  EVP_PKEY* key = nullptr;
  X509* certificate = nullptr;
  STACK_OF(X509)* chain = nullptr;
  const int parsed = PKCS12_parse(read.get(), passphrase.c_str(), &key, &certificate, &chain);
  SigningCertificate signing{printable(file), {certificate, X509_free}, {key, EVP_PKEY_free}, {}};
  while (chain != nullptr && sk_X509_num(chain) > 0)
    signing.chain.emplace_back(sk_X509_shift(chain), X509_free);
  sk_X509_free(chain);
  if (parsed != 1)
    throw Error(printable(file), "is encrypted in a way that OpenSSL does not read",
                "write it anew with the program that made it, with AES-256 and SHA-256");
  require_fit(signing);
  return signing;
}

void require_valid(const SigningCertificate& certificate, const std::string& at) {
  constexpr std::uint64_t ns_per_s = 1'000'000'000;
  auto moment = static_cast<std::time_t>(ns_since_1970(at).value_or(0) / ns_per_s);
  const ASN1_TIME* const begin = X509_get0_notBefore(certificate.certificate.get());
  const ASN1_TIME* const end = X509_get0_notAfter(certificate.certificate.get());
  if (X509_cmp_time(end, &moment) <= 0)
    throw Error(certificate.source, fmt::format("has a certificate that expired on {}", date_text(end)),
                "sign with a certificate that is valid now");
  if (X509_cmp_time(begin, &moment) > 0)
    throw Error(certificate.source,
                fmt::format("has a certificate that is not valid before {}", date_text(begin)),
                "check the clock of this computer, or sign with a certificate that is valid now");
}

std::string owner_of(const SigningCertificate& certificate) {
  X509_NAME* const subject = X509_get_subject_name(certificate.certificate.get());
  const int at = X509_NAME_get_index_by_NID(subject, NID_commonName, -1);
  if (at < 0) return "";
  unsigned char* utf8 = nullptr;
  const int size = ASN1_STRING_to_UTF8(&utf8, X509_NAME_ENTRY_get_data(X509_NAME_get_entry(subject, at)));
  if (size < 0) return "";
  std::string name(reinterpret_cast<const char*>(utf8), static_cast<std::size_t>(size));
  OPENSSL_free(utf8);
  return name;
}

}  // namespace rva
