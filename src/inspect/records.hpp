// Persistent records of inspections, with their findings and decisions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "inspect/inspection.hpp"
#include "inspect/inspection_tally.hpp"

namespace rva {

/// Every change is either complete and on the disk when the call returns, or has not happened. Every member
/// may be called from any thread, and throws Error when the disk or the database fails.
class Records {
 public:
  Records() = default;
  virtual ~Records() = default;
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  /// @return the id of the new inspection, which no other one has or had, also if that was removed
  /// @param dither number of captures of each view
  /// @param above  the new id is greater than this
  [[nodiscard]] virtual std::int64_t add_inspection(const InspectionOrder& order,
                                                    const std::string& created_at, int dither,
                                                    const std::vector<PanTilt>& views,
                                                    std::int64_t above) = 0;
  /// Ids of all inspections, newest first.
  [[nodiscard]] virtual std::vector<std::int64_t> inspections() const = 0;
  /// Summaries of the inspections that a filter selects, newest first; much faster than find() for each.
  [[nodiscard]] virtual std::vector<InspectionSummary> summaries(const InspectionFilter& filter) const = 0;
  /// Tallies of the inspections that a filter selects, newest first; much faster than history() for each.
  [[nodiscard]] virtual std::vector<InspectionTally> tallies(const InspectionFilter& filter) const = 0;
  /// Empty if there is no inspection with this id.
  [[nodiscard]] virtual std::optional<Inspection> find(std::int64_t id) const = 0;
  /// A complete comparison, which may be outdated; empty if there is none of this number.
  [[nodiscard]] virtual std::optional<RecordedComparison> comparison(std::int64_t id, int number) const = 0;
  /// All complete comparisons of an inspection, outdated ones included, newest first.
  [[nodiscard]] virtual std::vector<ComparedRound> rounds(std::int64_t id) const = 0;
  /// All of an inspection, superseded decisions and rounds included; empty if there is none with this id.
  [[nodiscard]] virtual std::optional<InspectionHistory> history(std::int64_t id) const = 0;

  // The following throw Error if the inspection does not exist or has been closed.

  virtual void set_views(std::int64_t id, const std::vector<PanTilt>& views) = 0;
  /// Records that a round of a side is in progress; set_side() completes it.
  virtual void begin_side(std::int64_t id, Side side, const BegunSide& begun) = 0;
  /// Completes a round of a side. The current comparison becomes outdated.
  virtual void set_side(std::int64_t id, Side side, const TakenSide& taken) = 0;
  /// Replaces the polygons that are left out of this view. The current comparison becomes outdated.
  virtual void set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) = 0;
  /// Replaces the plan of this view; null removes it. The current comparison becomes outdated.
  virtual void set_plan(std::int64_t id, int view, const Plan* plan) = 0;
  /// Records that a comparison is about to write into its folder.
  /// @param comparison with a number that no earlier one has
  virtual void begin_comparison(std::int64_t id, const RecordedComparison& comparison) = 0;
  /// Makes a comparison the current one. Earlier ones stay in the record with their findings and decisions.
  /// @param comparison with a number that no earlier one has
  virtual void set_comparison(std::int64_t id, const RecordedComparison& comparison,
                              const std::vector<ComparedView>& views,
                              const std::vector<ReviewedFinding>& findings) = 0;
  /// Records a decision on a finding. Earlier decisions are kept; the latest one applies.
  /// @param comparison number of the comparison that found it
  /// @throws Error when there is no such finding, or that comparison is not the current one
  virtual void decide(std::int64_t id, int comparison, int finding, const Decision& decision) = 0;
  /// Records a finding that a person marked. @return its number; `marked.number` has no effect
  [[nodiscard]] virtual int add_mark(std::int64_t id, const MarkedFinding& marked) = 0;
  /// Records a picture that was kept. @return its number; `snapshot.number` has no effect
  [[nodiscard]] virtual int add_snapshot(std::int64_t id, const Snapshot& snapshot) = 0;
  /// Appends items to the check-out list, all or none. @throws Error when the list would be too long
  virtual void add_items(std::int64_t id, const std::vector<ListedItem>& items, const std::string& person,
                         const std::string& taken_at) = 0;
  /// Records what became of an item; earlier statements are kept. @throws Error when there is no such item,
  /// or as require_valid()
  virtual void state_item(std::int64_t id, int item, const ItemStatement& statement) = 0;
  /// Records a decision on a marked finding; as decide(). @throws Error when there is no such mark
  virtual void decide_mark(std::int64_t id, int mark, const Decision& decision) = 0;
  /// Records all of these decisions, in their order, or none. @throws Error as decide() and decide_mark()
  virtual void decide_all(std::int64_t id, int comparison, const std::vector<FindingDecision>& decisions) = 0;
  /// Closes an inspection. @throws Error as require_closable()
  virtual void close(std::int64_t id, const Closing& closing) = 0;
  /// Removes an inspection of which nothing was captured or marked. @throws Error when something was
  virtual void remove(std::int64_t id) = 0;
};

}  // namespace rva
