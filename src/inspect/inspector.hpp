// An inspection, step by step: what a console asks for, done.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "core/options.hpp"
#include "core/progress.hpp"
#include "inspect/inspection_folder.hpp"
#include "inspect/readiness.hpp"
#include "inspect/records.hpp"
#include "inspect/side_capture.hpp"
#include "inspect/task_runner.hpp"
#include "robot/dither.hpp"

namespace rva {

/// Options of an inspector's captures and checks.
struct InspectorOptions {
  int frames = 80;
  int dither = 8;
  bool lamp = false;
  PoseReturnOptions pose_return{};
  ReadinessOptions readiness;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames,
          OptionField{"frames", "", 4, 10000, "depth frames of each view, over all of its captures"});
    visit(self.dither,
          OptionField{"dither", "", 1, most_dithers,
                      "captures of each view, a few servo steps apart; 1 where there is no robot"});
    visit(self.lamp,
          OptionField{"lamp", "", 0, 1, "with each capture as many infrared images under the camera's lamp"});
    PoseReturnOptions::describe(self.pose_return, visit);
    ReadinessOptions::describe(self.readiness, visit);
  }
};

/// What a person states, and the person's name.
struct Remark {
  std::string note;
  std::string person;
};

/// Long work is done by a thread of its own, one task at a time; what is asked meanwhile is refused with a
/// sentence. Whatever is complete is on the disk, so that another shift goes on after a power failure where
/// this one was. Every member may be called from any thread.
class Inspector {
 public:
  /// @param rig, records outlive this object
  /// @param data    folder of the captures, made where there is none
  /// @throws OptionError when an option is out of range or the camera has no lamp; Error when the folder
  /// cannot be made
  Inspector(const InspectionRig& rig, Records& records, std::filesystem::path data,
            const InspectorOptions& options = {});
  ~Inspector() = default;  ///< ends a task under way, as cancel() does
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// A new one, with the view where the camera is now. A robot that moves is waited for, up to three seconds.
  /// @throws Error when nobody's name is given, or the robot still moves or does not answer
  [[nodiscard]] std::int64_t begin(const InspectionOrder& order);
  /// Summaries of the inspections that a filter selects, newest first.
  [[nodiscard]] std::vector<InspectionSummary> summaries(const InspectionFilter& filter = {}) const {
    return records_.summaries(filter);
  }
  /// Tallies of the inspections that a filter selects, newest first.
  [[nodiscard]] std::vector<InspectionTally> tallies(const InspectionFilter& filter = {}) const {
    return records_.tallies(filter);
  }
  /// Records::comparison()
  [[nodiscard]] std::optional<RecordedComparison> comparison(std::int64_t id, int number) const {
    return records_.comparison(id, number);
  }
  /// What each comparison of an inspection showed, newest first.
  [[nodiscard]] std::vector<ComparedRound> rounds(std::int64_t id) const { return records_.rounds(id); }
  [[nodiscard]] bool has(std::int64_t id) const { return records_.find(id).has_value(); }
  /// @throws Error when there is none of this id
  [[nodiscard]] Inspection inspection(std::int64_t id) const;
  /// All that the records contain of an inspection. @throws Error when there is none of this id
  [[nodiscard]] InspectionHistory history(std::int64_t id) const;
  [[nodiscard]] InspectionFolder folder(std::int64_t id) const { return {data_, id}; }
  /// The folder of all inspections.
  [[nodiscard]] const std::filesystem::path& data() const { return data_; }
  /// The options of the check before a capture.
  [[nodiscard]] const ReadinessOptions& readiness_options() const { return options_.readiness; }
  /// The robot's geometry.
  [[nodiscard]] const PanTiltChain& chain() const { return rig_.chain; }

  /// @throws Error when the baseline has been begun, there is no view or more than 60, or one is beyond the
  ///         robot's limits (UsageError)
  void set_views(std::int64_t id, const std::vector<PanTilt>& views);

  /// Replaces what is left out of a view's comparison. A comparison that was made without it is no longer
  /// valid.
  /// @param ignored in pixels of the view's first initial depth image
  /// @throws Error when there is no baseline or no such view, or a capture or comparison is under way
  void set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored);

  /// Replaces what the work order states will change in a view; null removes it. A comparison that was made
  /// without it is no longer valid.
  /// @param plan in the picture, or in the frame, of the view's first initial capture
  /// @throws Error as set_ignored()
  void set_plan(std::int64_t id, int view, const Plan* plan);

  // Each starts a task. @throws Error when another is under way that is no check of readiness or of a
  // baseline, which are ended, or when the inspection is not so far.

  void check_readiness();
  /// Of every view. A baseline that was interrupted goes on with the views that a robot has taken; a complete
  /// one is not taken again: the work has been done on it. It is compared with itself (check_baseline()), and
  /// is complete whatever becomes of that. The final side is taken as a whole, in a round of its own each
  /// time, and compared at once; earlier rounds stay where they are.
  /// @param replaced the robot was taken away and put back since the baseline: its foot stands elsewhere
  void capture(std::int64_t id, Side side, const std::string& person, bool replaced);

  /// The value of `replaced` for a final side that was interrupted; empty where there is none.
  [[nodiscard]] std::optional<bool> replaced_before_final(const Inspection& inspection) const;
  /// The final side again with the initial one, as after a failure in between.
  void compare(std::int64_t id);

  /// Ends the task under way, if any: soon after. A start that was asked for before does not happen.
  void cancel() { tasks_.cancel(); }
  /// The same where it is a capture, which would move the robot on.
  void stop_capture() { tasks_.stop_capture(); }

  [[nodiscard]] TaskState task() const { return tasks_.task(); }
  /// TaskRunner::ended()
  [[nodiscard]] EndedTasks ended_tasks() const { return tasks_.ended(); }
  /// Of the last check; empty before.
  [[nodiscard]] std::optional<Readiness> readiness() const;

  /// @param comparison number of the one whose findings the person saw
  /// @throws Error when there is no such finding, it was captured or compared anew since, or is just now, or
  ///         nobody's name is given
  void decide(std::int64_t id, int comparison, int finding, const Decision& decision);

  /// Records a finding that a person marked in the pictures of a view.
  /// @param comparison number of the one whose pictures the person saw
  /// @param box        in pixels of these pictures
  /// @return its number
  /// @throws Error when that comparison is not the current one, or the view or the box is none
  int mark(std::int64_t id, int comparison, int view, const Box& box, const Remark& remark);
  /// Records a finding that a person marked in a picture of its own, which is kept.
  /// @param marked with its box, and its position if that was measured
  int mark_in_picture(std::int64_t id, const MarkedFinding& marked, const ColorImage& picture,
                      const Remark& remark);
  /// Keeps a picture with a note. @return its number
  /// @throws Error when nobody's name is given, the inspection is closed, or the picture cannot be written
  int keep_snapshot(std::int64_t id, const ColorImage& picture, const Remark& remark);
  /// Decides on a marked finding. @throws Error as decide()
  void decide_mark(std::int64_t id, int mark, const Decision& decision);
  /// Decides on several findings, marked ones among them: on all or, when it throws, on none.
  /// @throws Error as decide(), or when there are no decisions
  void decide_all(std::int64_t id, int comparison, std::vector<FindingDecision> decisions);

  /// Appends items to the check-out list, all or none.
  /// @throws Error when nobody's name is given, a line is not within the limits, or the list would be too
  /// long
  void check_out(std::int64_t id, const std::vector<ListedItem>& items, const std::string& person);
  /// States what became of an item. @param statement `stated_at` has no effect
  /// @throws Error when nobody's name is given, there is no such item, or it may not be stated so
  void state_item(std::int64_t id, int item, ItemStatement statement);

  /// Closes an inspection; nothing can be changed afterwards.
  /// @param comparison number of the one that the person reviewed
  /// @throws Error as require_closable(), or when a capture or comparison is under way
  void close(std::int64_t id, int comparison, const Remark& remark);
  /// Writes the signed package of a closed inspection.
  using WritesPackage = std::function<void(const InspectionHistory& history, const Progress& progress)>;
  /// Starts a task that calls `write`.
  /// @throws Error when the inspection is not closed, or another task is under way that is no check
  void sign(std::int64_t id, WritesPackage write);
  /// Removes an inspection of which nothing has been captured or marked. @throws Error when something has
  void remove(std::int64_t id);

 private:
  [[nodiscard]] TaskRunner::Work capture_work(std::int64_t id, Side side, const std::string& person,
                                              bool replaced);
  void compare_now(std::int64_t id);
  void check_now(std::int64_t id);
  [[nodiscard]] bool is_changing(std::int64_t id) const;
  void require_unchanging(std::int64_t id, const std::string& remedy) const;
  [[nodiscard]] int record_mark(const Inspection& inspection, MarkedFinding marked, const Remark& remark);
  void change_views(std::int64_t id, const std::vector<PanTilt>& views);
  void require_baseline_view(std::int64_t id, int view) const;
  [[nodiscard]] BegunSide round_for(const Inspection& inspection, Side side, const std::string& person,
                                    const std::string& base) const;
  [[nodiscard]] std::filesystem::path baseline_to_return_to(const Inspection& inspection, Side side,
                                                            const std::string& base) const;
  void require_same_rig(const Inspection& inspection) const;
  void require_baseline(const Inspection& inspection) const;
  [[nodiscard]] std::vector<PanTilt> waypoints_of(const Inspection& inspection) const;

  InspectionRig rig_;
  Records& records_;
  std::filesystem::path data_;
  InspectorOptions options_;
  mutable std::mutex mutex_;  // guards the next one
  std::optional<Readiness> readiness_;
  TaskRunner tasks_;  // last: its thread uses all above
};

}  // namespace rva
