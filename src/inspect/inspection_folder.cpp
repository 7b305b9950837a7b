#include "inspect/inspection_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "map/view_capture.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

int round_of(const Inspection& inspection, Side side) {
  const std::optional<TakenSide>& taken = side == Side::initial ? inspection.initial : inspection.final;
  if (taken) return taken->round;
  const auto begun = inspection.begun.find(side);
  return begun == inspection.begun.end() ? 1 : begun->second.round;
}

}  // namespace

InspectionFolder::InspectionFolder(const fs::path& data, std::int64_t id)
    : path_(data / "inspections" / fmt::format("{:06}", id)) {}

fs::path InspectionFolder::side(Side side, int round) const {
  return path_ / (round == 1 ? std::string(name_of(side)) : fmt::format("{}-{}", name_of(side), round));
}

fs::path InspectionFolder::capture(Side side, const Inspection& inspection, int view, int dither) const {
  const int number = view * inspection.dither + dither;
  return this->side(side, round_of(inspection, side)) / view_name(static_cast<std::size_t>(number));
}

std::string InspectionFolder::comparison_name(int number) { return fmt::format("comparison-{}", number); }

std::optional<std::int64_t> InspectionFolder::number_in(const std::string& name) {
  std::int64_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [last, failure] = std::from_chars(name.data(), end, number);
  const bool digits = failure == std::errc() && last == end && number >= 0 && name.front() != '-';
  return digits ? std::optional(number) : std::nullopt;
}

std::int64_t InspectionFolder::greatest_id(const fs::path& data) {
  std::int64_t greatest = 0;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(data / "inspections", failure))
    greatest = std::max(greatest, number_in(entry.path().filename()).value_or(0));
  return greatest;
}

fs::path InspectionFolder::result_in(const fs::path& comparison, int view) {
  return comparison / "results" / view_name(static_cast<std::size_t>(view));
}

fs::path InspectionFolder::result(const Inspection& inspection, int view) const {
  return inspection.comparison ? result_in(path_ / inspection.comparison->folder, view) : fs::path();
}

fs::path InspectionFolder::map(const RecordedComparison& comparison) const {
  return in_comparison(comparison, "map.ply");
}

fs::path InspectionFolder::changes(const RecordedComparison& comparison) const {
  return in_comparison(comparison, "changes.ply");
}

// All comparisons of the first versions have the same folder, whose files belong to the last of them, and of
// that one alone the round of captures is known.
fs::path InspectionFolder::in_comparison(const RecordedComparison& comparison, const fs::path& name) const {
  const bool replaced = comparison.folder.empty() && comparison.final_round == 0;
  return replaced ? fs::path() : path_ / comparison.folder / name;
}

void InspectionFolder::require_no_links(const fs::path& inside) const {
  const fs::path root = path_.lexically_normal();
  const fs::path wanted = inside.lexically_normal();
  const fs::path within = wanted.lexically_relative(root);
  if (within.empty() || *within.begin() == "..")
    throw Error(printable(inside), "is not in the folder of its inspection",
                "restore the data folder from a backup");
  std::error_code ignored;
  for (fs::path folder = wanted; folder != root.parent_path().parent_path(); folder = folder.parent_path()) {
    if (fs::is_symlink(fs::symlink_status(folder, ignored)))
      throw Error(printable(folder), "is a link, which would lead captures out of the data folder",
                  "replace it with a folder, or use another data folder");
  }
}

}  // namespace rva
