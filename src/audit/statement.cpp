#include "audit/statement.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/json_object.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* statement_type = "https://in-toto.io/Statement/v1";

Error wrong(const std::string& source) {
  return {source, "is not the statement of an inspection as this version of rva writes it",
          "get the package again, or use the version of rva that wrote it"};
}

std::optional<StatedTimeStamp> time_stamp_in(const JsonObject& predicate) {
  if (!predicate.has("time_stamp")) return std::nullopt;
  const JsonObject stated = predicate.object("time_stamp");
  return StatedTimeStamp{stated.string("server"),
                         stated.has("failure") ? stated.string("failure") : std::string()};
}

Statement parsed(const nlohmann::json& json, const std::string& source) {
  const JsonObject object(json, source);
  if (object.string("_type") != statement_type || object.string("predicateType") != inspection_predicate_type)
    throw wrong(source);
  const JsonObject predicate = object.object("predicate");
  Statement statement{{predicate.integer("inspection"), predicate.string("aircraft"),
                       predicate.string("zone"), predicate.string("work_order")},
                      predicate.string("made_at"),
                      {},
                      predicate.string("log"),
                      {},
                      time_stamp_in(predicate)};
  for (const nlohmann::json& key : json["predicate"].value("signers", nlohmann::json::array())) {
    if (!key.is_string()) throw wrong(source);
    statement.signers.push_back(key);
  }
  for (const nlohmann::json& element : json.at("subject")) {
    const JsonObject subject(element, source, "subject");
    const std::optional<Digest> digest = digest_from_hex(subject.object("digest").string("sha256"));
    if (!digest || !statement.subjects.emplace(subject.string("name"), *digest).second) throw wrong(source);
  }
  return statement;
}

}  // namespace

std::string text_of(const Statement& statement) {
  Json subjects = Json::array();
  for (const auto& [name, digest] : statement.subjects)
    subjects.push_back({{"name", name}, {"digest", {{"sha256", hex_of(bytes_of(digest))}}}});
  Json predicate{{"inspection", statement.inspection.number},
                 {"aircraft", statement.inspection.aircraft},
                 {"zone", statement.inspection.zone},
                 {"work_order", statement.inspection.work_order},
                 {"made_at", statement.made_at},
                 {"signers", statement.signers},
                 {"log", statement.log}};
  if (const auto& stamp = statement.time_stamp) {
    predicate["time_stamp"]["server"] = stamp->server;
    if (!stamp->is_there()) predicate["time_stamp"]["failure"] = stamp->failure;
  }
  return json_text(Json{{"_type", statement_type},
                        {"subject", std::move(subjects)},
                        {"predicateType", inspection_predicate_type},
                        {"predicate", std::move(predicate)}});
}

Statement parse_statement(const std::string& text, const std::string& source) {
  const nlohmann::json json = parse_json(text, source);
  const auto subjects = json.is_object() ? json.find("subject") : json.end();
  if (subjects == json.end() || !subjects->is_array()) throw wrong(source);
  Statement statement = parsed(json, source);
  if (text_of(statement) != text) throw wrong(source);
  return statement;
}

}  // namespace rva
