// Paths of an inspection's captures and pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// The folder of one inspection, DATA/inspections/000001/. It contains:
///   - initial/000/ and final/000/: captures, those of one view one after another; later rounds are in
///     final-2/000/ and so on;
///   - baseline-check/: what check_baseline() writes;
///   - marks/001.png: live pictures in which findings were marked;
///   - comparison-1/results/000/: the results of each view (view_result_files());
///   - comparison-1/map.ply and comparison-1/changes.ply: point clouds of the bay and of the changes;
///   - comparison-1/shown_findings.npy: what the classifier was shown (npy_of()) of the findings that have a
///     class, in the order of their numbers.
/// Later captures and comparisons do not replace earlier ones.
class InspectionFolder {
 public:
  InspectionFolder(const std::filesystem::path& data, std::int64_t id);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path side(Side side, int round) const;
  /// The folder of one capture in the last complete round, or in the round in progress if none is complete.
  /// @param dither index of the capture within its view, from 0, below inspection.dither
  [[nodiscard]] std::filesystem::path capture(Side side, const Inspection& inspection, int view,
                                              int dither) const;

  /// The folder that check_baseline() writes.
  [[nodiscard]] std::filesystem::path baseline_check() const { return path_ / baseline_check_name; }
  static constexpr const char* baseline_check_name = "baseline-check";
  /// The folder of live pictures in which findings were marked.
  static constexpr const char* marks_name = "marks";
  /// The folder of live pictures that were kept as snapshots.
  static constexpr const char* snapshots_name = "snapshots";
  /// The file of a comparison that has what the classifier was shown.
  static constexpr const char* shown_findings = "shown_findings.npy";

  /// The name of a comparison's folder in this one.
  [[nodiscard]] static std::string comparison_name(int number);
  /// The number that a name consisting of digits stands for; empty for other names.
  [[nodiscard]] static std::optional<std::int64_t> number_in(const std::string& name);
  /// The greatest id among the folders of all inspections; 0 if there are none.
  [[nodiscard]] static std::int64_t greatest_id(const std::filesystem::path& data);
  /// The folder of a view's results within a comparison's folder.
  [[nodiscard]] static std::filesystem::path result_in(const std::filesystem::path& comparison, int view);

  /// The folder of a view's results of the valid comparison; empty if there is none.
  [[nodiscard]] std::filesystem::path result(const Inspection& inspection, int view) const;

  // Files and point clouds of a comparison, also of an earlier one. Empty where they were replaced by those
  // of a later one: the first versions kept those of the last comparison alone.

  /// A file of a comparison. @param name relative to the comparison's folder
  [[nodiscard]] std::filesystem::path in_comparison(const RecordedComparison& comparison,
                                                    const std::filesystem::path& name) const;
  [[nodiscard]] std::filesystem::path map(const RecordedComparison& comparison) const;
  [[nodiscard]] std::filesystem::path changes(const RecordedComparison& comparison) const;

  /// Refuses symbolic links, which would redirect what is written here to another location.
  /// @param inside a folder within this one that is about to be written, or this one
  /// @throws Error when it is not in this folder, or when it, or a folder between it and the data folder, is
  ///         a symbolic link
  void require_no_links(const std::filesystem::path& inside) const;

 private:
  std::filesystem::path path_;
};

}  // namespace rva
