#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "report/or_reason.hpp"
#include "report/report_sections.hpp"
#include "report/report_words.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::vector<std::string> folders_of(const InspectionHistory& history, const InspectionFolder& folder) {
  std::vector<std::string> folders;
  for (const CapturedRound& round : history.captured)
    folders.push_back(
        folder.side(round.side, round.taken.round).lexically_relative(folder.path()).generic_string());
  for (auto round = history.rounds.rbegin(); round != history.rounds.rend(); ++round)
    if (!round->comparison.folder.empty()) folders.push_back(round->comparison.folder);
  for (const char* const other : {InspectionFolder::baseline_check_name, InspectionFolder::marks_name,
                                  InspectionFolder::snapshots_name}) {
    std::error_code ignored;
    if (fs::exists(folder.path() / other, ignored)) folders.emplace_back(other);
  }
  return folders;
}

// Paths relative to the inspection's folder, in the order of their bytes.
std::vector<std::string> files_of(const InspectionFolder& folder, const std::string& part) {
  std::error_code failure;
  std::vector<std::string> files;
  fs::recursive_directory_iterator inside(folder.path() / part, failure);
  if (failure)
    throw Error(printable(folder.path() / part), "is in the records but cannot be read",
                "restore the data folder from a backup");
  for (const fs::directory_entry& entry : inside) {
    folder.require_no_links(entry.path());
    if (entry.is_regular_file())
      files.push_back(entry.path().lexically_relative(folder.path()).generic_string());
  }
  std::ranges::sort(files);
  return files;
}

// The SHA-256 of what `sha256sum` prints of the files.
std::string checksum_of(const InspectionFolder& folder, const std::vector<std::string>& files) {
  std::string lines;
  for (const std::string& file : files)
    lines += hex_of(bytes_of(sha256_of_file(folder.path() / file))) + "  " + file + "\n";
  return hex_of(bytes_of(sha256(lines)));
}

}  // namespace

Content checksums_section(const InspectionHistory& history, const InspectionFolder& folder) {
  ReportTable table{.role = PartRole::checksum_table,
                    .head = {Content::text("Folder"), Content::text("SHA-256")},
                    .rows = {}};
  for (const std::string& part : folders_of(history, folder)) {
    table.rows.push_back({Content::text(part), or_reason([&] {
                            const std::vector<std::string> files = files_of(folder, part);
                            return Content::of(PartRole::code, Content::text(checksum_of(folder, files))) +
                                   Content::text(" of " + counted(files.size(), "file", "files"));
                          })});
  }
  if (table.rows.empty()) return {};
  return Content::of(PartRole::heading, Content::text("Checksums")) + content_of(table) +
         Content::of(
             PartRole::legend,
             Content::text(
                 "To compute one again, in the inspection's folder or in data/ of its signed package: ") +
                 Content::of(PartRole::code, Content::text("find FOLDER -type f -print0 | LC_ALL=C sort -z | "
                                                           "xargs -0 sha256sum | sha256sum")));
}

}  // namespace rva
