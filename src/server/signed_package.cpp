#include "server/signed_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "audit/envelope.hpp"
#include "audit/package_files.hpp"
#include "audit/site_log.hpp"
#include "audit/statement.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/remains.hpp"
#include "inspect/inspection_folder.hpp"
#include "server/inspection_export.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* signed_folder = "signed";

std::vector<std::string> files_of_package() {
  std::vector<std::string> files = package_files();
  files.emplace_back(package_file::time_stamp);
  for (const std::string& file : exported_files()) files.push_back(package_file::payload + file);
  return files;
}

OutputFolder new_package(const fs::path& out) {
  try {
    return {out, files_of_package(), Existing::refuse};
  } catch (const ExistsError& error) {
    throw Error(error.source(), "already exists, and signed packages are never replaced",
                "choose another folder");
  }
}

fs::path package_folder(const fs::path& data, std::int64_t id, int number) {
  return data / signed_folder / fmt::format("{:06}-{}", id, number);
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// A package that was damaged is listed all the same: it does not make the inspection unreadable.
SignedPackage described(const fs::path& data, const fs::path& package) {
  SignedPackage described{package.lexically_relative(data).generic_string(), {}, {}};
  try {
    const fs::path file = package / package_file::envelope;
    const std::vector<std::byte> bytes = read_file(file);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const Statement statement =
        parse_statement(parse_envelope(text, printable(file)).payload, printable(file));
    described.signed_at = statement.made_at;
    described.signers = statement.signers;
  } catch (const Error&) {
    described.signers.clear();
  }
  return described;
}

}  // namespace

void write_signed_package(const InspectionHistory& history, const fs::path& data, const fs::path& out,
                          const PackageSigning& signing, const Progress& progress) {
  // A log of another key is refused before a large inspection is copied.
  if (is_log(signing.log)) static_cast<void>(read_log(signing.log, signing.log_key.public_key()));
  OutputFolder package = new_package(out);
  fs::create_directory(package.path(package_file::payload));
  write_exported_inspection(history, data, package.path(package_file::payload), progress);
  const InspectionOrder& order = history.inspection.order;
  seal_package(package.path(""), {history.inspection.id, order.aircraft, order.zone, order.work_order},
               time_of_making(), signing);
  package.commit();
}

fs::path next_signed_package(const fs::path& data, std::int64_t id) {
  int number = 1;
  while (is_there(package_folder(data, id, number))) ++number;
  return package_folder(data, id, number);
}

std::vector<SignedPackage> signed_packages(const fs::path& data, std::int64_t id) {
  std::vector<SignedPackage> packages;
  for (int number = 1; is_there(package_folder(data, id, number)); ++number)
    packages.push_back(described(data, package_folder(data, id, number)));
  return packages;
}

std::set<std::int64_t> signed_inspections(const fs::path& data) {
  std::set<std::int64_t> signed_ones;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(data / signed_folder, failure)) {
    const std::string name = entry.path().filename();
    const std::size_t dash = name.find('-');
    const std::optional<std::int64_t> id = InspectionFolder::number_in(name.substr(0, dash));
    const bool is_package =
        dash != name.npos && InspectionFolder::number_in(name.substr(dash + 1)).has_value();
    if (id && is_package) signed_ones.insert(*id);
  }
  return signed_ones;
}

std::vector<std::string> remove_incomplete_packages(const fs::path& data) {
  std::vector<std::string> done;
  std::vector<fs::path> remains;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(data / signed_folder, failure))
    if (is_name_of_remains(entry.path()) && !entry.is_symlink() &&
        holds_only(entry.path(), files_of_package()))
      remains.push_back(entry.path());
  std::ranges::sort(remains);
  for (const fs::path& path : remains) {
    fs::remove_all(path, failure);
    done.push_back(fmt::format("{}: {}", printable(path),
                               failure
                                   ? "is incomplete and cannot be removed: check the folder's permissions"
                                   : "removed: it was not complete when the program was stopped; sign the "
                                     "inspection again"));
  }
  return done;
}

}  // namespace rva
