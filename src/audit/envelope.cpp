#include "audit/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"

namespace rva {
namespace {

std::string base64_at(const JsonObject& object, const char* key) {
  if (std::optional<std::string> bytes = bytes_from_either_base64(object.string(key)))
    return *std::move(bytes);
  throw Error(object.name_of(key), "is not base64", "get the file again");
}

}  // namespace

std::string pre_authentication_encoding(std::string_view payload_type, std::string_view payload) {
  return fmt::format("DSSEv1 {} {} {} {}", payload_type.size(), payload_type, payload.size(), payload);
}

Envelope parse_envelope(const std::string& text, const std::string& source) {
  const nlohmann::json json = parse_json(text, source);
  const JsonObject object(json, source);
  Envelope envelope{object.string("payloadType"), base64_at(object, "payload"), {}};
  if (!object.has("signatures") || !json["signatures"].is_array())
    throw Error(object.name_of("signatures"), "is not a list", "get the file again");
  for (const nlohmann::json& element : json["signatures"]) {
    const JsonObject signature(element, source, "signatures");
    envelope.signatures.push_back(
        {signature.optional_string("keyid").value_or(""), base64_at(signature, "sig")});
  }
  return envelope;
}

std::string text_of(const Envelope& envelope) {
  nlohmann::ordered_json json{{"payload", base64_of(envelope.payload)},
                              {"payloadType", envelope.payload_type},
                              {"signatures", nlohmann::ordered_json::array()}};
  for (const EnvelopeSignature& signature : envelope.signatures)
    json["signatures"].push_back({{"keyid", signature.key}, {"sig", base64_of(signature.bytes)}});
  return json_file_text(json);
}

void sign(Envelope& envelope, const SigningKey& key) {
  const Signature signature = key.sign(pre_authentication_encoding(envelope.payload_type, envelope.payload));
  envelope.signatures.push_back({name_with_id(key.public_key()), std::string(bytes_of(signature))});
}

std::vector<PublicKey> signers_of(const Envelope& envelope, std::span<const PublicKey> keys) {
  const std::string message = pre_authentication_encoding(envelope.payload_type, envelope.payload);
  std::vector<PublicKey> signers;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(signers), [&](const PublicKey& key) {
    return std::any_of(envelope.signatures.begin(), envelope.signatures.end(),
                       [&](const auto& signature) { return is_signature(signature.bytes, message, key); });
  });
  return signers;
}

}  // namespace rva
