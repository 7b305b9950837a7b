#include "inspect/recovery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "capture/folder/capture_writer.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/remains.hpp"
#include "inspect/baseline_check.hpp"
#include "inspect/inspection_folder.hpp"
#include "inspect/view_comparison.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

// In the order of their names. Links are of neither type.
std::vector<fs::path> entries_in(const fs::path& folder, fs::file_type type) {
  std::vector<fs::path> found;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    std::error_code unknown;
    if (entry.symlink_status(unknown).type() == type) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

std::vector<fs::path> folders_in(const fs::path& folder) {
  return entries_in(folder, fs::file_type::directory);
}

std::vector<fs::path> files_in(const fs::path& folder) { return entries_in(folder, fs::file_type::regular); }

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool holds_captures(const fs::path& side) { return is_there(side / "000" / "capture.json"); }

// "001" of "001.partial-17-0"
std::string target_of(const fs::path& remains) {
  const std::string name = remains.filename();
  return name.substr(0, name.find(".partial-"));
}

bool is_three_digits(const std::string& name) {
  return name.size() == 3 && name.find_first_not_of("0123456789") == std::string::npos;
}

/// Repairs one inspection's folder. Unknown files are left alone.
class Repair {
 public:
  Repair(fs::path folder, const Inspection& inspection, std::vector<std::string>& done)
      : folder_(std::move(folder)), inspection_(inspection), done_(done) {}

  void run() {
    for (const char* const side : {"initial", "final"}) restore_replaced(side);
    remove_unfinished_comparisons();
    for (const fs::path& side : folders_in(folder_)) remove_unfinished_views(side);
    remove_unfinished_clouds();
    remove_unfinished_pictures();
    name_unrecorded_comparisons();
    name_unrecorded_pictures();
  }

 private:
  // An earlier version of the program moved a side to SIDE.replaced while it was taken again. The moved side
  // is restored, and the views taken since become a round of their own.
  void restore_replaced(const std::string& side) {
    const fs::path current = folder_ / side;
    const fs::path aside = folder_ / (side + ".replaced");
    if (!holds_captures(aside)) return;
    std::error_code failure;
    if (is_there(current)) {
      int round = 2;
      while (is_there(folder_ / fmt::format("{}-{}", side, round))) ++round;
      fs::rename(current, folder_ / fmt::format("{}-{}", side, round), failure);
    }
    if (!failure) fs::rename(aside, current, failure);
    tell(current, failure ? "cannot be restored: check the folder's permissions"
                          : "restored: it was being captured again when the program was stopped");
  }

  // Such a comparison may be complete, but it was never recorded, so nobody has seen it.
  void remove_unfinished_comparisons() {
    for (const std::string& name : inspection_.unfinished_comparisons) {
      if (holds_only(folder_ / name, comparison_files())) remove(folder_ / name);
    }
    for (const fs::path& path : folders_in(folder_)) {
      if (!is_name_of_remains(path)) continue;
      const std::string target = target_of(path);
      const bool is_comparison = target.starts_with("comparison-") && holds_only(path, comparison_files());
      const bool is_check =
          target == InspectionFolder::baseline_check_name && holds_only(path, baseline_check_files());
      if (is_comparison || is_check) remove(path);
    }
  }

  // Removes unfinished captures, and unfinished results of an earlier version of the program.
  void remove_unfinished_views(const fs::path& side) {
    const std::vector<std::string> files =
        side.filename() == "results" ? view_result_files() : capture_files();
    for (const fs::path& path : folders_in(side)) {
      if (is_name_of_remains(path) && is_three_digits(target_of(path)) && holds_only(path, files))
        remove(path);
    }
  }

  void remove_unfinished_clouds() {
    for (const char* const cloud : {"map.ply.partial", "changes.ply.partial"}) {
      if (is_there(folder_ / cloud)) remove(folder_ / cloud);
    }
  }

  void remove_unfinished_pictures() {
    for (const char* const kind : {InspectionFolder::marks_name, InspectionFolder::snapshots_name})
      for (const fs::path& path : files_in(folder_ / kind))
        if (is_name_of_remains(path)) remove(path);
  }

  // A picture is written before the finding that was marked in it, or the snapshot, is recorded.
  void name_unrecorded_pictures() {
    name_unrecorded(InspectionFolder::marks_name, inspection_.marked,
                    "shows no finding that is in the records; it is kept");
    name_unrecorded(InspectionFolder::snapshots_name, inspection_.snapshots,
                    "is no snapshot that is in the records; it is kept");
  }

  void name_unrecorded(const char* kind, const auto& recorded, const char* said) {
    for (const fs::path& path : files_in(folder_ / kind)) {
      const auto is_its_picture = [&](const auto& record) { return folder_ / record.picture == path; };
      if (std::ranges::none_of(recorded, is_its_picture)) tell(path, said);
    }
  }

  void name_unrecorded_comparisons() {
    for (const fs::path& path : folders_in(folder_)) {
      const std::string name = path.filename();
      const std::string prefix = InspectionFolder::comparison_name(0).substr(0, 11);
      if (!name.starts_with(prefix) || is_name_of_remains(path)) continue;
      const std::optional<std::int64_t> number = InspectionFolder::number_in(name.substr(prefix.size()));
      if (number && *number > inspection_.comparisons)
        tell(path, "belongs to a comparison that is not in the records; it is kept");
    }
  }

  void remove(const fs::path& path) {
    std::error_code failure;
    fs::remove_all(path, failure);
    tell(path, failure ? "is incomplete and cannot be removed: check the folder's permissions"
                       : "removed: it was not complete when the program was stopped");
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
    const std::optional<std::int64_t> id = InspectionFolder::number_in(folder.filename());
    if (!id) continue;
    if (const std::optional<Inspection> inspection = records.find(*id))
      Repair(folder, *inspection, done).run();
    else
      done.push_back(fmt::format("{}: belongs to an inspection that is not in the records; it is kept",
                                 printable(folder)));
  }
  return done;
}

}  // namespace rva
