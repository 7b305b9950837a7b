// Signatures that readers of PDF verify.
#pragma once

#include <string>

#include "report/pdf/signing_certificate.hpp"

namespace rva {

/// Adds an invisible signature by an incremental update: the bytes of the unsigned file come first and are
/// unchanged. It is of the baseline level B-B of PAdES (ETSI EN 319 142-1): a detached CMS signature with
/// SHA-256, `ETSI.CAdES.detached`, of all bytes but itself, with the certificate, its chain and a
/// signing-certificate-v2 attribute. It has no time stamp: the time is that of the signer's clock.
/// @param pdf of pdf_report()
/// @param signed_at ISO 8601 in UTC, stated as the time of signing
/// @throws Error when the certificate is not valid at that time, or OpenSSL fails
[[nodiscard]] std::string signed_pdf(const std::string& pdf, const SigningCertificate& certificate,
                                     const std::string& signed_at);

}  // namespace rva
