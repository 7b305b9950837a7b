#include "inspect/recovery.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/path_text.hpp"
#include "core/remains.hpp"
#include "inspect/inspection_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    if (entry.symlink_status(failure).type() == fs::file_type::directory) found.push_back(entry.path());
  }
  return found;
}

// The digits at the end of `name` after `prefix`; empty where it is another name.
std::optional<std::int64_t> number_after(std::string_view prefix, const std::string& name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  std::int64_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [last, failure] = std::from_chars(name.data() + prefix.size(), end, number);
  return failure == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

/// Repairs one inspection's folder.
class Repair {
 public:
  Repair(fs::path folder, const Inspection& inspection, std::vector<std::string>& done)
      : folder_(std::move(folder)), inspection_(inspection), done_(done) {}

  void run() {
    restore_replaced();
    remove_unfinished(folder_);
    for (const fs::path& side : folders_in(folder_)) remove_unfinished(side);
    remove_unrecorded();
  }

 private:
  // Version 0 of the layout moved a final side to SIDE.replaced while it was taken anew: the new views become
  // a round of their own.
  void restore_replaced() {
    for (const char* const side : {"initial", "final"}) {
      const fs::path place = folder_ / side;
      const fs::path aside = folder_ / fmt::format("{}.replaced", side);
      std::error_code failure;
      if (!fs::is_directory(fs::symlink_status(aside, failure))) continue;
      if (fs::exists(fs::symlink_status(place, failure))) {
        int round = 2;
        while (fs::exists(fs::symlink_status(folder_ / fmt::format("{}-{}", side, round), failure))) ++round;
        fs::rename(place, folder_ / fmt::format("{}-{}", side, round), failure);
      }
      if (!failure) fs::rename(aside, place, failure);
      if (!failure) tell(place, "restored: it was being taken anew when the program was stopped");
    }
  }

  void remove_unfinished(const fs::path& folder) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
      const bool cloud =
          entry.path().filename() == "map.ply.partial" || entry.path().filename() == "changes.ply.partial";
      if (cloud || is_name_of_remains(entry.path()))
        remove(entry.path(), "removed: it was not complete when the program was stopped");
    }
  }

  // Complete, but the program was killed before it was recorded: it is made again, under the same number.
  void remove_unrecorded() {
    for (const fs::path& comparison : folders_in(folder_)) {
      const auto number = number_after("comparison-", comparison.filename());
      if (number && *number > inspection_.comparisons)
        remove(comparison, "removed: it was not recorded when the program was stopped; compare again");
    }
  }

  void remove(const fs::path& path, const char* said) {
    std::error_code failure;
    fs::remove_all(path, failure);
    tell(path, failure ? "is incomplete, and cannot be removed: look at the folder's rights" : said);
  }

  void tell(const fs::path& path, const char* said) {
    done_.push_back(fmt::format("{}: {}", printable(path), said));
  }

  fs::path folder_;
  const Inspection& inspection_;
  std::vector<std::string>& done_;
};

}  // namespace

std::vector<std::string> recover_data(const fs::path& data, const Records& records) {
  std::vector<std::string> done;
  for (const fs::path& folder : folders_in(data / "inspections")) {
    const auto id = number_after("", folder.filename());
    const std::optional<Inspection> inspection = id ? records.find(*id) : std::nullopt;
    if (inspection) Repair(folder, *inspection, done).run();
  }
  return done;
}

}  // namespace rva
