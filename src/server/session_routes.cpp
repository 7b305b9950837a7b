#include "core/clock.hpp"
#include "core/json_object.hpp"
#include "server/api.hpp"
#include "server/conversation.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

std::string cookie(const std::string& token, bool secure, bool ended) {
  std::string text = "rva_session=" + token + "; Path=/; HttpOnly; SameSite=Strict";
  if (secure) text += "; Secure";
  if (ended) text += "; Max-Age=0";
  return text;
}

}  // namespace

ApiResponse Api::get_session(const Call& call) const {
  Json body{{"protocol", Conversation::protocol}, {"sign_in_needed", parts_.sessions.needed()}};
  if (call.person) {
    body["name"] = call.person->name;
    body["role"] = name_of(call.person->role);
  }
  return {200, "application/json", json_text(body)};
}

ApiResponse Api::sign_in(const Call& call) const {
  const std::string name = text_field(call.body, "name");
  const std::string password = text_field(call.body, "password", most_field_bytes * 2);
  const Sessions::SignIn result =
      parts_.sessions.sign_in(name, password, call.request.from, steady_clock().now_s());
  switch (result.answer) {
    case Sessions::Answer::wrong:
      return refusal(401, "wrong-password", "sign-in: name or password is wrong; try again");
    case Sessions::Answer::too_many:
      return refusal(429, "too-many", "sign-in: too many wrong passwords; wait a minute");
    case Sessions::Answer::signed_in:
      break;
  }
  return {200, "application/json", "{}", {{"Set-Cookie", cookie(result.token, secure_cookie_, false)}}};
}

ApiResponse Api::sign_out(const Call& call) const {
  parts_.sessions.sign_out(call.request.token);
  return {200, "application/json", "{}", {{"Set-Cookie", cookie("", secure_cookie_, true)}}};
}

}  // namespace rva
