#include <algorithm>

#include "audit/site_keys.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"
#include "server/signed_package.hpp"

namespace rva {
namespace {

constexpr std::size_t most_signers = 8;

/// What proves that a person is there and agrees.
struct Credentials {
  std::string name;
  std::string password;
};

Credentials credentials_in(const Json& body, const std::string& name) {
  return {name, text_field(body, "password", most_field_bytes * 2)};
}

// The person of the request first, then those beside.
std::vector<Credentials> signers_in(const Json& body, const std::string& person) {
  std::vector<Credentials> signers{credentials_in(body, person)};
  const auto others = body.find("others");
  if (others == body.end() || others->is_null()) return signers;
  if (!others->is_array() || others->size() >= most_signers)
    throw ApiError(400, "bad-request", "others", "is not a list of up to seven people", "see docs/api.md");
  for (const Json& other : *others) {
    if (!other.is_object())
      throw ApiError(400, "bad-request", "others", "contains something else than a person",
                     "see docs/api.md");
    const std::string name = text_field(other, "name");
    if (std::ranges::find(signers, name, &Credentials::name) != signers.end())
      throw ApiError(400, "bad-request", "others", printable(name) + " is there twice",
                     "name each person once");
    signers.push_back(credentials_in(other, name));
  }
  return signers;
}

void require_closed(const Inspection& inspection) {
  if (!inspection.closing)
    throw Error("inspection " + std::to_string(inspection.id), "is not closed", "close it, then sign it");
}

}  // namespace

// Nobody signs for somebody else, and no viewer signs.
PersonRole Api::confirmed_role(const std::string& name, const std::string& password,
                               const std::string& from) const {
  const Sessions::Confirmation confirmed =
      parts_.sessions.confirm(name, password, from, steady_clock().now_s());
  switch (confirmed.answer) {
    case Sessions::Answer::wrong:
      throw ApiError(403, "wrong-password", printable(name), "the name or the password is wrong",
                     "try again");
    case Sessions::Answer::too_many:
      throw ApiError(429, "too-many", printable(name), "there were too many wrong passwords",
                     "wait a minute");
    case Sessions::Answer::signed_in:
      break;
  }
  if (confirmed.role < PersonRole::operator_)
    throw ApiError(403, "not-allowed", printable(name),
                   "is not allowed to sign in the role of " + std::string(name_of(confirmed.role)),
                   "ask somebody with the required role");
  return confirmed.role;
}

ApiResponse Api::sign(const Call& call) const {
  const std::int64_t id = inspection_id(call);
  if (parts_.keys == nullptr || !call.person || call.person->name.empty())
    throw Error("signing", "needs accounts with passwords",
                "ask the administrator to add an account for each person");
  require_closed(parts_.inspector.inspection(id));
  const std::vector<Credentials> people = signers_in(call.body, call.person->name);
  bool inspector = false;
  for (const Credentials& one : people)
    inspector |= confirmed_role(one.name, one.password, call.request.from) >= PersonRole::inspector;
  if (!inspector)
    throw ApiError(403, "not-allowed", "signing", "needs an inspector among those who sign",
                   "ask an inspector to sign, too");
  std::vector<SigningKey> signers;
  for (const Credentials& one : people) signers.push_back(parts_.keys->key_of(one.name, one.password));
  const std::filesystem::path& data = parts_.inspector.data();
  const PackageSigning signing{signers, parts_.keys->log_key(), data / "log", parts_.time_stamping};
  parts_.inspector.sign(id, [data, id, signing](const InspectionHistory& history, const Progress& progress) {
    write_signed_package(history, data, next_signed_package(data, id), signing, progress);
  });
  return {202, "application/json", "{}"};
}

ApiResponse Api::get_keys(const Call& /*call*/) const {
  Json keys = Json::array();
  if (parts_.keys != nullptr)
    for (const PublicKey& key : parts_.keys->public_keys()) keys.push_back(verifier_key(key));
  return {200, "application/json", json_text(Json{{"keys", keys}})};
}

}  // namespace rva
