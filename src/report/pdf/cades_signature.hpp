// Detached CMS signatures of the kind that PAdES needs.
#pragma once

#include <string>
#include <string_view>

#include "report/pdf/signing_certificate.hpp"

namespace rva {

/// A CMS SignedData (RFC 5652) in DER without the content that it signs, with the certificate and its chain.
/// The signed attributes are content-type, message-digest and signing-certificate-v2 (RFC 5035), but not
/// signing-time, which PAdES forbids.
/// @throws Error when OpenSSL fails
[[nodiscard]] std::string cades_signature(std::string_view content, const SigningCertificate& certificate);

}  // namespace rva
