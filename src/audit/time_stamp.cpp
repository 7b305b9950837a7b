#include "audit/time_stamp.hpp"

#include <fmt/format.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/pkcs7.h>
#include <openssl/ts.h>
#include <openssl/x509_vfy.h>

#include <ctime>
#include <memory>
#include <vector>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

/// Frees what OpenSSL has made.
template <auto free>
struct Frees {
  void operator()(auto* object) const { free(object); }
};
template <typename Object, auto free>
using Owned = std::unique_ptr<Object, Frees<free>>;

using Request = Owned<TS_REQ, TS_REQ_free>;
using Answer = Owned<TS_RESP, TS_RESP_free>;
using Token = Owned<PKCS7, PKCS7_free>;
using Info = Owned<TS_TST_INFO, TS_TST_INFO_free>;
using Store = Owned<X509_STORE, X509_STORE_free>;
using Verification = Owned<TS_VERIFY_CTX, TS_VERIFY_CTX_free>;

constexpr const char* get_again = "do not rely on this time stamp";
constexpr const char* ask_another = "check the time stamp server, or use another one";
constexpr int nonce_bits = 64;

// Only a lack of memory makes these calls fail.
void require_memory(bool succeeded) {
  if (!succeeded) throw Error("OpenSSL", "has no memory left", "close other programs, and try again");
}

template <typename Object>
std::string der_of(const Object* object, int (*encode)(const Object*, unsigned char**)) {
  unsigned char* bytes = nullptr;
  const int size = encode(object, &bytes);
  require_memory(size > 0);
  std::string der(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  OPENSSL_free(bytes);
  return der;
}

// Null if the text is not the encoding of exactly one such object.
template <typename Owner>
Owner read_der(std::string_view text, const auto& decode) {
  const auto* const begin = reinterpret_cast<const unsigned char*>(text.data());
  const unsigned char* at = begin;
  Owner object(decode(nullptr, &at, static_cast<long>(text.size())));
  ERR_clear_error();
  if (at != begin + text.size()) object.reset();
  return object;
}

// Without a nonce.
Request request_for(std::string_view bytes) {
  Request request(TS_REQ_new());
  const Owned<TS_MSG_IMPRINT, TS_MSG_IMPRINT_free> imprint(TS_MSG_IMPRINT_new());
  const Owned<X509_ALGOR, X509_ALGOR_free> algorithm(X509_ALGOR_new());
  require_memory(request != nullptr && imprint != nullptr && algorithm != nullptr);
  Digest digest = sha256(bytes);
  require_memory(X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr) == 1 &&
                 TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get()) == 1 &&
                 TS_MSG_IMPRINT_set_msg(imprint.get(), digest.data(), static_cast<int>(digest.size())) == 1 &&
                 TS_REQ_set_version(request.get(), 1) == 1 &&
                 TS_REQ_set_msg_imprint(request.get(), imprint.get()) == 1 &&
                 TS_REQ_set_cert_req(request.get(), 1) == 1);
  return request;
}

bool has_certificates(const PKCS7* token) {
  return PKCS7_type_is_signed(token) == 1 && token->d.sign != nullptr && sk_X509_num(token->d.sign->cert) > 0;
}

Token token_from(std::string_view der, const std::string& source) {
  Token token = read_der<Token>(der, d2i_PKCS7);
  if (token == nullptr || der_of<PKCS7>(token.get(), i2d_PKCS7) != der || !has_certificates(token.get()))
    throw Error(source, "is not a time stamp with the certificate of its authority", get_again);
  return token;
}

// YYYYMMDDhhmmss[.fraction]Z (RFC 3161, section 2.4.2).
std::string time_in(const TS_TST_INFO* info, const std::string& source) {
  const ASN1_GENERALIZEDTIME* const time = info == nullptr ? nullptr : TS_TST_INFO_get_time(info);
  constexpr std::size_t digits = 14;
  const std::string text = time == nullptr
                               ? ""
                               : std::string(reinterpret_cast<const char*>(ASN1_STRING_get0_data(time)),
                                             static_cast<std::size_t>(ASN1_STRING_length(time)));
  const bool is_time = text.size() > digits && text.back() == 'Z' &&
                       text.find_first_not_of("0123456789") >= digits && ASN1_TIME_check(time) == 1;
  if (!is_time) throw Error(source, "is a time stamp without a time", get_again);
  return fmt::format("{}-{}-{}T{}:{}:{}", text.substr(0, 4), text.substr(4, 2), text.substr(6, 2),
                     text.substr(8, 2), text.substr(10, 2), text.substr(12));
}

std::time_t seconds_of(const ASN1_GENERALIZEDTIME* time) {
  std::tm parts{};
  ASN1_TIME_to_tm(time, &parts);
  return timegm(&parts);
}

// Trusts the CAs of a file or, without one, the certificates in the token, at the time that it states.
Store store_for(const PKCS7* token, const TS_TST_INFO* info, const std::optional<fs::path>& trusted_ca) {
  Store store(X509_STORE_new());
  require_memory(store != nullptr);
  if (trusted_ca) {
    static_cast<void>(read_text_file(*trusted_ca));  // states why a file cannot be read
    if (X509_STORE_load_locations(store.get(), trusted_ca->c_str(), nullptr) != 1)
      throw Error(printable(*trusted_ca), "contains no certificate", "give a PEM file of the authority's CA");
  } else {
    const STACK_OF(X509)* const certificates = token->d.sign->cert;
    for (int k = 0; k < sk_X509_num(certificates); ++k)
      X509_STORE_add_cert(store.get(), sk_X509_value(certificates, k));
    X509_STORE_set_flags(store.get(), X509_V_FLAG_PARTIAL_CHAIN);
  }
  X509_VERIFY_PARAM_set_time(X509_STORE_get0_param(store.get()), seconds_of(TS_TST_INFO_get_time(info)));
  return store;
}

// Compares a token with a request: imprint, nonce if the request has one, and the signature.
void require_fit(PKCS7* token, TS_REQ* request, Store store, const std::string& source) {
  const Verification verification(TS_REQ_to_TS_VERIFY_CTX(request, nullptr));
  require_memory(verification != nullptr);
  TS_VERIFY_CTX_add_flags(verification.get(), TS_VFY_SIGNATURE);
  TS_VERIFY_CTX_set_store(verification.get(), store.release());
  ERR_clear_error();
  if (TS_RESP_verify_token(verification.get(), token) == 1) return;
  const unsigned long failure = ERR_peek_last_error();
  const char* const reason = ERR_reason_error_string(failure);
  ERR_clear_error();
  throw Error(source,
              fmt::format("is not a valid time stamp of what it belongs to ({})",
                          reason == nullptr ? "it does not fit" : reason),
              get_again);
}

std::string authority_of(PKCS7* token) {
  const Owned<STACK_OF(X509), [](STACK_OF(X509) * list) { sk_X509_free(list); }> signers(
      PKCS7_get0_signers(token, nullptr, 0));
  const Owned<BIO, BIO_free_all> text(BIO_new(BIO_s_mem()));
  require_memory(signers != nullptr && text != nullptr);
  X509_NAME_print_ex(text.get(), X509_get_subject_name(sk_X509_value(signers.get(), 0)), 0,
                     XN_FLAG_RFC2253 & ~static_cast<unsigned long>(ASN1_STRFLGS_ESC_MSB));
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(text.get(), &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

}  // namespace

std::string time_stamp_request(std::string_view bytes) {
  const Request request = request_for(bytes);
  const Owned<BIGNUM, BN_free> number(BN_new());
  require_memory(number != nullptr &&
                 BN_rand(number.get(), nonce_bits, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY) == 1);
  const Owned<ASN1_INTEGER, ASN1_INTEGER_free> nonce(BN_to_ASN1_INTEGER(number.get(), nullptr));
  require_memory(nonce != nullptr && TS_REQ_set_nonce(request.get(), nonce.get()) == 1);
  return der_of<TS_REQ>(request.get(), i2d_TS_REQ);
}

std::string time_stamp_in(std::string_view answer, std::string_view request, const std::string& source) {
  const Answer read = read_der<Answer>(answer, d2i_TS_RESP);
  if (read == nullptr) throw Error(source, "answered with something else than a time stamp", ask_another);
  PKCS7* const token = TS_RESP_get_token(read.get());
  if (token == nullptr) throw Error(source, "refused to make a time stamp", ask_another);
  const std::string der = der_of<PKCS7>(token, i2d_PKCS7);
  const Token whole = token_from(der, source);
  const Info info(PKCS7_to_TS_TST_INFO(whole.get()));
  static_cast<void>(time_in(info.get(), source));
  const Request asked = read_der<Request>(request, d2i_TS_REQ);
  require_memory(asked != nullptr);
  require_fit(whole.get(), asked.get(), store_for(whole.get(), info.get(), std::nullopt), source);
  return der;
}

TimeStamp check_time_stamp(std::string_view token, std::string_view bytes,
                           const std::optional<fs::path>& trusted_ca, const std::string& source) {
  const Token whole = token_from(token, source);
  const Info info(PKCS7_to_TS_TST_INFO(whole.get()));
  const std::string time = time_in(info.get(), source);
  const Request expected = request_for(bytes);
  require_fit(whole.get(), expected.get(), store_for(whole.get(), info.get(), trusted_ca), source);
  return {time, authority_of(whole.get()), trusted_ca.has_value()};
}

}  // namespace rva
