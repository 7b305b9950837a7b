// The pictures of a report: small, as they are for paper. The captures and results that they are drawn from
// are in the inspection's folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "depth/image.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "report/object_groups.hpp"
#include "report/report_content.hpp"

namespace rva {

/// The pictures of one comparison (review_picture_files()), each of which is read once.
class ComparisonPictures {
 public:
  ComparisonPictures(const InspectionFolder& folder, const RecordedComparison& comparison)
      : folder_(folder), comparison_(folder.in_comparison(comparison, "")) {}

  /// False where they were replaced by those of a later comparison, as the first versions did.
  [[nodiscard]] bool exist() const { return !comparison_.empty(); }

  /// A view after the work, with the outlines and labels of the objects found in it, and stripes where
  /// nothing could be found: in colour, or, in darkness, depth. @throws Error when a picture that must be
  /// there cannot be read
  [[nodiscard]] Content view(int view, const std::vector<ObjectGroup>& groups);

  /// A finding before and after the work, in colour where there is light and as depth.
  /// @throws Error as view()
  [[nodiscard]] Content before_and_after(const ReviewedFinding& finding);

 private:
  [[nodiscard]] const ColorImage& picture(int view, const std::string& name);
  [[nodiscard]] bool is_lit(int view);

  InspectionFolder folder_;
  std::filesystem::path comparison_;
  std::map<std::filesystem::path, ColorImage> read_;
  std::map<int, bool> lit_;  ///< is_lit() by view
};

/// The surroundings of a marked finding in the picture in which it was marked, with its box.
/// @throws Error when it cannot be read
[[nodiscard]] Content marked_picture(const InspectionFolder& folder, const MarkedFinding& marked);

/// A picture that a person kept. @throws Error when it cannot be read
[[nodiscard]] Content snapshot_picture(const InspectionFolder& folder, const Snapshot& snapshot);

}  // namespace rva
