// Where an inspection's captures and pictures lie.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// DATA/inspections/000001/{initial,final}/000/ (captures, those of one view after each other), of later
/// rounds
/// .../final-2/000/, ...; .../comparison-1/results/000/ (of each view, what `rva detect` writes, and pictures
/// for the review), .../comparison-1/{map,changes}.ply; .../baseline-check/. Nothing here is replaced by a
/// later capture or comparison.
class InspectionFolder {
 public:
  InspectionFolder(const std::filesystem::path& data, std::int64_t id);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path side(Side side, int round) const;
  /// Of the last complete round, or of the one that is under way where none is complete.
  /// @param dither of the view's captures, below inspection.dither
  [[nodiscard]] std::filesystem::path capture(Side side, const Inspection& inspection, int view,
                                              int dither) const;

  /// The folder that check_baseline() writes.
  [[nodiscard]] std::filesystem::path baseline_check() const { return path_ / baseline_check_name; }
  static constexpr const char* baseline_check_name = "baseline-check";

  /// The name of a comparison's folder in this one.
  [[nodiscard]] static std::string comparison_name(int number);
  /// Of a name that is digits alone; empty of others.
  [[nodiscard]] static std::optional<std::int64_t> number_in(const std::string& name);
  /// The greatest id of all inspections' folders; 0 where there is none.
  [[nodiscard]] static std::int64_t greatest_id(const std::filesystem::path& data);
  /// Of a comparison's folder.
  [[nodiscard]] static std::filesystem::path result_in(const std::filesystem::path& comparison, int view);

  // Of the comparison that holds; empty where there is none.

  [[nodiscard]] std::filesystem::path result(const Inspection& inspection, int view) const;
  [[nodiscard]] std::filesystem::path map(const Inspection& inspection) const;
  [[nodiscard]] std::filesystem::path changes(const Inspection& inspection) const;

  /// A link would lead what is written here to another place.
  /// @param inside a folder in this one that is about to be written, or this one
  /// @throws Error when it, or a folder between it and the data folder, is a symbolic link
  void require_no_links(const std::filesystem::path& inside) const;

 private:
  [[nodiscard]] std::filesystem::path in_comparison(const Inspection& inspection,
                                                    const std::filesystem::path& name) const;

  std::filesystem::path path_;
};

}  // namespace rva
