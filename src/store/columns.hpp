// Values as columns of SqliteRecords' tables: lists are JSON, missing values are null.
#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <Eigen/Core>
#include <array>
#include <optional>

#include "inspect/reviewed_finding.hpp"

namespace rva {

// Bind a value to a parameter, from 1; empty ones stay null.
void bind_value(SQLite::Statement& statement, int index, const std::optional<double>& number);
void bind_value(SQLite::Statement& statement, int index, const std::optional<Eigen::Vector3d>& point);
void bind_value(SQLite::Statement& statement, int index, const std::optional<std::array<double, 2>>& extent);
void bind_value(SQLite::Statement& statement, int index, const Box& box);

// Read a value back; empty for null.
[[nodiscard]] std::optional<double> number_in(const SQLite::Column& column);
[[nodiscard]] std::optional<Eigen::Vector3d> point_in(const SQLite::Column& column);
[[nodiscard]] std::optional<std::array<double, 2>> extent_in(const SQLite::Column& column);
[[nodiscard]] Box box_in(const SQLite::Column& column);

/// Reads the columns verdict, note, person, decided_at, round and object, which are the first ones of the
/// row.
[[nodiscard]] Decision recorded_decision_in(SQLite::Statement& row);

/// The same as what applies to a finding: empty if the decision was withdrawn.
[[nodiscard]] std::optional<Decision> decision_in(SQLite::Statement& row);

}  // namespace rva
