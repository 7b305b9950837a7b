#include "doctor/checkup.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

void append(Json& json, const char* part, const CheckedItems& items) {
  for (const CheckedItem& item : items) {
    Json one{{"part", part}, {"name", item.name}, {"state", name_of(item.state)}, {"result", item.result}};
    if (!item.advice.empty()) one["advice"] = item.advice;
    if (!item.values.empty()) one["values"] = item.values;
    json.push_back(std::move(one));
  }
}

bool has(const Checkup& checkup, CheckState state) {
  const std::array parts{&checkup.computer, &checkup.camera, &checkup.robot};
  return std::ranges::any_of(parts, [state](const CheckedItems* items) {
    return std::ranges::find(*items, state, &CheckedItem::state) != items->end();
  });
}

}  // namespace

CheckedItem passed(std::string name, std::string result) {
  return {std::move(name), CheckState::ok, std::move(result), "", {}};
}

CheckedItem not_tried(std::string name, std::string reason) {
  return {std::move(name), CheckState::not_tried, std::move(reason), "", {}};
}

CheckedItems none_tried(const std::vector<std::string>& names, const std::string& reason) {
  CheckedItems items;
  for (const std::string& name : names) items.push_back(not_tried(name, reason));
  return items;
}

CheckedItem failed(std::string name, const Error& error) {
  return {std::move(name), CheckState::failed, error.source() + ": " + error.problem(), error.remedy(), {}};
}

CheckState worst(const Checkup& checkup) {
  if (has(checkup, CheckState::failed)) return CheckState::failed;
  return has(checkup, CheckState::warning) ? CheckState::warning : CheckState::ok;
}

Json json_of(const Checkup& checkup) {
  Json json = Json::array();
  append(json, "computer", checkup.computer);
  append(json, "camera", checkup.camera);
  append(json, "robot", checkup.robot);
  return json;
}

}  // namespace rva
