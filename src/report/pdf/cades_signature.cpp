#include "report/pdf/cades_signature.hpp"

#include <openssl/cms.h>
#include <openssl/objects.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/error.hpp"

namespace rva {
namespace {

using Cms = std::unique_ptr<CMS_ContentInfo, decltype(&CMS_ContentInfo_free)>;

void require(bool succeeded, const SigningCertificate& certificate) {
  if (!succeeded)
    throw Error(certificate.source, "cannot be used to sign: OpenSSL failed",
                "check the file with openssl pkcs12 -info");
}

// What is signed: the DER of a SET OF all signed attributes, whose order is that of their bytes (RFC
// 5652, 5.4).
std::string signed_attributes(CMS_SignerInfo* signer) {
  std::vector<std::string> attributes;
  std::size_t size = 0;
  for (int k = 0; k < CMS_signed_get_attr_count(signer); ++k) {
    unsigned char* bytes = nullptr;
    const int count = i2d_X509_ATTRIBUTE(CMS_signed_get_attr(signer, k), &bytes);
    attributes.emplace_back(reinterpret_cast<const char*>(bytes),
                            static_cast<std::size_t>(std::max(count, 0)));
    OPENSSL_free(bytes);
    size += attributes.back().size();
  }
  std::ranges::sort(attributes);
  const int whole = ASN1_object_size(1, static_cast<int>(size), V_ASN1_SET);
  std::string der(static_cast<std::size_t>(whole) - size, '\0');
  auto* at = reinterpret_cast<unsigned char*>(der.data());
  ASN1_put_object(&at, 1, static_cast<int>(size), V_ASN1_SET, V_ASN1_UNIVERSAL);
  for (const std::string& attribute : attributes) der += attribute;
  return der;
}

std::vector<unsigned char> digest_of(std::string_view content) {
  std::vector<unsigned char> digest(EVP_MAX_MD_SIZE);
  unsigned int size = 0;
  if (EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) size = 0;
  digest.resize(size);
  return digest;
}

std::vector<unsigned char> signature_of(const std::string& content, EVP_PKEY* key) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(content.data());
  std::size_t size = 0;
  if (EVP_DigestSignInit(context.get(), nullptr, EVP_sha256(), nullptr, key) != 1 ||
      EVP_DigestSign(context.get(), nullptr, &size, bytes, content.size()) != 1)
    return {};
  std::vector<unsigned char> signature(size);
  if (EVP_DigestSign(context.get(), signature.data(), &size, bytes, content.size()) != 1) return {};
  signature.resize(size);
  return signature;
}

bool add_attributes(CMS_SignerInfo* signer, std::string_view content) {
  const std::vector<unsigned char> digest = digest_of(content);
  const ASN1_OBJECT* const data = OBJ_nid2obj(NID_pkcs7_data);
  return CMS_signed_add1_attr_by_NID(signer, NID_pkcs9_contentType, V_ASN1_OBJECT, data, -1) == 1 &&
         CMS_signed_add1_attr_by_NID(signer, NID_pkcs9_messageDigest, V_ASN1_OCTET_STRING, digest.data(),
                                     static_cast<int>(digest.size())) == 1;
}

}  // namespace

std::string cades_signature(std::string_view content, const SigningCertificate& certificate) {
  constexpr unsigned int flags = CMS_DETACHED | CMS_BINARY | CMS_PARTIAL | CMS_NOSMIMECAP | CMS_CADES;
  const Cms cms(CMS_sign(nullptr, nullptr, nullptr, nullptr, flags), CMS_ContentInfo_free);
  require(cms != nullptr, certificate);
  CMS_SignerInfo* const signer =
      CMS_add1_signer(cms.get(), certificate.certificate.get(), certificate.key.get(), EVP_sha256(), flags);
  require(signer != nullptr, certificate);
  for (const auto& issuer : certificate.chain)
    require(CMS_add1_cert(cms.get(), issuer.get()) == 1, certificate);
  // CMS_final() and CMS_SignerInfo_sign() would add signing-time, so the attributes are signed here.
  require(add_attributes(signer, content), certificate);
  const std::vector<unsigned char> signature = signature_of(signed_attributes(signer), certificate.key.get());
  require(!signature.empty() && ASN1_OCTET_STRING_set(CMS_SignerInfo_get0_signature(signer), signature.data(),
                                                      static_cast<int>(signature.size())) == 1,
          certificate);
  unsigned char* bytes = nullptr;
  const int size = i2d_CMS_ContentInfo(cms.get(), &bytes);
  require(size > 0, certificate);
  std::string der(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  OPENSSL_free(bytes);
  return der;
}

}  // namespace rva
