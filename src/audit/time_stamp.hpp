// Time stamps of RFC 3161: statements, signed by an authority, that some bytes existed at a time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rva {

/// What a time stamp states.
struct TimeStamp {
  std::string time;                ///< when the bytes existed, by the authority's clock: ISO 8601 in UTC
  std::string authority;           ///< subject of the certificate that signed, as RFC 2253 writes it
  bool authority_checked = false;  ///< whether the certificate was checked against that of a trusted CA
};

/// The question for a time stamp of bytes, as DER (TimeStampReq): their SHA-256 and a random nonce. The
/// bytes themselves are not sent.
[[nodiscard]] std::string time_stamp_request(std::string_view bytes);

/// Reads the answer to a question, as DER (TimeStampResp), and checks that it is one to this question.
/// @param request time_stamp_request()
/// @param source  where the answer is from, for errors
/// @return the time stamp alone (TimeStampToken), as DER
/// @throws Error when the answer is none, refuses, or is to another question, and as check_time_stamp()
[[nodiscard]] std::string time_stamp_in(std::string_view answer, std::string_view request,
                                        const std::string& source);

/// Checks that a time stamp is one of these bytes, by SHA-256, and signed with a certificate for time stamps
/// that was valid at the time which it states. Revocation is not checked.
/// @param token      TimeStampToken as DER, with the authority's certificate
/// @param trusted_ca PEM file with the certificates of the CAs that are trusted; without it, the certificate
///                   in the token is taken as it is, and the authority is not checked
/// @param source     where the token is from, for errors
/// @throws Error when it is not, or the file cannot be read
[[nodiscard]] TimeStamp check_time_stamp(std::string_view token, std::string_view bytes,
                                         const std::optional<std::filesystem::path>& trusted_ca,
                                         const std::string& source);

}  // namespace rva
