// Where an inspection's captures and pictures lie.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// DATA/inspections/000001/{initial,final}/000/ (captures, those of one view after each other),
/// .../results/000/ (of each view, what `rva detect` writes, and pictures for the review),
/// .../{map,changes}.ply.
class InspectionFolder {
 public:
  InspectionFolder(const std::filesystem::path& data, std::int64_t id);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path side(Side side) const { return path_ / name_of(side); }
  /// @param dither of the view's captures, below inspection.dither
  [[nodiscard]] std::filesystem::path capture(Side side, const Inspection& inspection, int view,
                                              int dither) const;
  [[nodiscard]] std::filesystem::path result(int view) const;
  [[nodiscard]] std::filesystem::path map() const { return path_ / "map.ply"; }
  [[nodiscard]] std::filesystem::path changes() const { return path_ / "changes.ply"; }

 private:
  std::filesystem::path path_;
};

}  // namespace rva
