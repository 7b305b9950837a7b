#include "report/pdf/pdf_signature.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "report/pdf/cades_signature.hpp"
#include "report/pdf/pdf_update.hpp"

namespace rva {
namespace {

constexpr std::string_view contents_key = "/Contents <";
constexpr std::string_view range_key = "/ByteRange [";
constexpr std::string_view unknown_range = "0 0000000000 0000000000 0000000000";

std::size_t encoded_size(X509* certificate) {
  return static_cast<std::size_t>(i2d_X509(certificate, nullptr));
}

// Bytes that the signature may need: twice its key, its certificates, and what is around them.
std::size_t most_bytes(const SigningCertificate& certificate) {
  constexpr std::size_t other = 2048;
  std::size_t bytes = other + encoded_size(certificate.certificate.get()) +
                      2 * static_cast<std::size_t>(EVP_PKEY_get_size(certificate.key.get()));
  for (const auto& issuer : certificate.chain) bytes += encoded_size(issuer.get());
  return bytes;
}

// The signature with zeros in place of what is only known once the file is complete.
std::string signature_dictionary(const SigningCertificate& certificate, const std::string& signed_at) {
  return fmt::format(
      "<< /Type /Sig /Filter /Adobe.PPKLite /SubFilter /ETSI.CAdES.detached /M {} /Name {}\n{}{}]\n{}{}> >>",
      pdf::time_string(signed_at), pdf::text_string(owner_of(certificate)), range_key, unknown_range,
      contents_key, std::string(2 * most_bytes(certificate), '0'));
}

std::string with_field(const std::string& pdf, const SigningCertificate& certificate,
                       const std::string& signed_at) {
  pdf::PdfUpdate update(pdf);
  const int page = update.first_page();
  const int signature = update.add(signature_dictionary(certificate, signed_at));
  const int field =
      update.add(fmt::format("<< /Type /Annot /Subtype /Widget /FT /Sig /T (Signature) /F 132 /Rect [0 0 0 "
                             "0] /P {} 0 R /V {} 0 R >>",
                             page, signature));
  update.extend(page, fmt::format("/Annots [{} 0 R]", field));
  // The version of the file, and the extension that defines the kind of signature.
  update.extend(
      update.catalog(),
      fmt::format("/AcroForm << /Fields [{} 0 R] /SigFlags 3 >> /Version /1.7 /Extensions << /ESIC << "
                  "/BaseVersion /1.7 /ExtensionLevel 2 >> >>",
                  field));
  return std::move(update).finished();
}

}  // namespace

std::string signed_pdf(const std::string& pdf, const SigningCertificate& certificate,
                       const std::string& signed_at) {
  require_valid(certificate, signed_at);
  std::string file = with_field(pdf, certificate, signed_at);
  // Both ends of the hexadecimal digits belong to what is not signed.
  const std::size_t begin = file.rfind(contents_key) + contents_key.size() - 1;
  const std::size_t end = file.find('>', begin) + 1;
  const std::string range = fmt::format("0 {:010} {:010} {:010}", begin, end, file.size() - end);
  file.replace(file.rfind(range_key) + range_key.size(), unknown_range.size(), range);
  const std::string signature =
      hex_of(cades_signature(file.substr(0, begin) + file.substr(end), certificate));
  if (signature.size() + 2 > end - begin)
    throw Error(certificate.source, "has a signature larger than its place in the file",
                "report this as an error of RVA");
  file.replace(begin + 1, signature.size(), signature);
  return file;
}

}  // namespace rva
