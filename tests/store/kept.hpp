// Records in a database of a test's own.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "inspect/inspection_folder.hpp"
#include "store/sqlite_records.hpp"
#include "tests/temporary_folder.hpp"

namespace rva::test {

class Kept : public testing::Test {
 protected:
  Kept() { open(); }
  void open() {
    records_.reset();
    records_ = std::make_unique<SqliteRecords>(folder_ / "rva.db");
  }
  std::int64_t add() {
    return records_->add_inspection({"N1", "bay 3", "WO 7", "Ann O'Neil \"x\"; drop table view"},
                                    "2026-01-01T00:00:00Z", 4, {{0, 0}}, 0);
  }

  TemporaryFolder folder_;
  std::unique_ptr<SqliteRecords> records_;
};

inline RecordedComparison comparison(int number) {
  return {number, "t", InspectionFolder::comparison_name(number)};
}

inline ReviewedFinding finding(int number) {
  ReviewedFinding reviewed;
  reviewed.number = reviewed.same_as = number;
  reviewed.view = 1;
  reviewed.finding.kind = number % 2 == 0 ? ChangeKind::removed : ChangeKind::added;
  reviewed.finding.box = {1, 2, 3, 4};
  reviewed.finding.centroid = {2.5, 4.25};
  reviewed.finding.position_m = Eigen::Vector3d(0.1, -0.2, 1.0 / 3.0);
  reviewed.in_foot_m = Eigen::Vector3d(1, 2, 3);
  reviewed.finding.size_mm = {7.1, 8.2};
  reviewed.finding.height_mm = 6.9;
  reviewed.finding.above_surroundings_mm = 5.9;
  reviewed.finding.background_jump = true;
  reviewed.finding.top_above_surroundings_mm = 7.5;
  reviewed.likely_class = "fastener";
  reviewed.class_probability = 0.75;
  reviewed.finding.top_is_least = true;
  reviewed.clear_px = 120;
  reviewed.finding.score = 9.5;
  reviewed.finding.p_value = 1e-9;
  return reviewed;
}

}  // namespace rva::test
