#include "cli/recorded_inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "store/sqlite_records.hpp"

namespace fs = std::filesystem;

namespace rva::cli {

namespace {

fs::path database_of(const std::string& data) {
  fs::path database = fs::path(data) / "rva.db";
  std::error_code ignored;  // a folder that cannot be read has no records either
  if (!fs::exists(database, ignored))
    throw Error(printable(data), "contains no inspections (no rva.db)", "give the data folder of rva serve");
  return database;
}

}  // namespace

void add_data_folder(CLI::App& command, std::string& data) {
  command.add_option("--data", data, "folder of inspections, as for rva serve")->required()->type_name("DIR");
}

void add_recorded_inspection(CLI::App& command, std::string& data, std::int64_t& inspection) {
  add_data_folder(command, data);
  command.add_option("--inspection", inspection, "number of the inspection")
      ->required()
      ->check(CLI::PositiveNumber)
      ->type_name("N");
}

std::vector<std::int64_t> recorded_inspections(const std::string& data) {
  std::vector<std::int64_t> numbers = SqliteRecords(database_of(data)).inspections();
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<InspectionSummary> recorded_summaries(const std::string& data, const InspectionFilter& filter) {
  return SqliteRecords(database_of(data)).summaries(filter);
}

std::vector<InspectionTally> recorded_tallies(const std::string& data, const InspectionFilter& filter) {
  return SqliteRecords(database_of(data)).tallies(filter);
}

InspectionHistory recorded_inspection(const std::string& data, std::int64_t number) {
  const fs::path database = database_of(data);
  std::optional<InspectionHistory> history = SqliteRecords(database).history(number);
  if (!history)
    throw Error(printable(database), fmt::format("has no inspection {}", number),
                "give a number of the console's list");
  return *std::move(history);
}

void visit_recorded(const std::string& data, const std::function<void(const InspectionHistory&)>& visit) {
  const SqliteRecords records(database_of(data));
  std::vector<std::int64_t> numbers = records.inspections();
  std::ranges::sort(numbers);
  for (const std::int64_t number : numbers)
    if (const std::optional<InspectionHistory> history = records.history(number)) visit(*history);
}

}  // namespace rva::cli
