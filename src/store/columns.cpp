#include "store/columns.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/json_object.hpp"

namespace rva {
namespace {

using nlohmann::json;

template <typename Numbers>
std::optional<Numbers> numbers_in(const SQLite::Column& column) {
  if (column.isNull()) return std::nullopt;
  return json::parse(column.getString()).get<Numbers>();
}

}  // namespace

void bind_value(SQLite::Statement& statement, int index, const std::optional<double>& number) {
  if (number) statement.bind(index, *number);
}

void bind_value(SQLite::Statement& statement, int index, const std::optional<Eigen::Vector3d>& point) {
  if (point) statement.bind(index, json_text(json{point->x(), point->y(), point->z()}));
}

void bind_value(SQLite::Statement& statement, int index, const std::optional<std::array<double, 2>>& extent) {
  if (extent) statement.bind(index, json_text(json(*extent)));
}

void bind_value(SQLite::Statement& statement, int index, const Box& box) {
  statement.bind(index, json_text(json{box.x, box.y, box.width, box.height}));
}

std::optional<double> number_in(const SQLite::Column& column) {
  return column.isNull() ? std::nullopt : std::optional(column.getDouble());
}

std::optional<Eigen::Vector3d> point_in(const SQLite::Column& column) {
  const auto list = numbers_in<std::array<double, 3>>(column);
  return list ? std::optional(Eigen::Vector3d(list->data())) : std::nullopt;
}

std::optional<std::array<double, 2>> extent_in(const SQLite::Column& column) {
  return numbers_in<std::array<double, 2>>(column);
}

Box box_in(const SQLite::Column& column) {
  const auto list = numbers_in<std::array<int, 4>>(column).value();
  return {list[0], list[1], list[2], list[3]};
}

Decision recorded_decision_in(SQLite::Statement& row) {
  return {.verdict = value_of<Verdict>(row.getColumn(0).getString()).value_or(Verdict::second_look),
          .note = row.getColumn(1),
          .person = row.getColumn(2),
          .decided_at = row.getColumn(3),
          .round = row.getColumn(4),
          .object = row.getColumn(5)};
}

std::optional<Decision> decision_in(SQLite::Statement& row) {
  Decision decision = recorded_decision_in(row);
  return decision.verdict == Verdict::undecided ? std::nullopt : std::optional(std::move(decision));
}

}  // namespace rva
