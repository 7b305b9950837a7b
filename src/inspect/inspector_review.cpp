// The review of an inspection: decisions, marks, the check-out list, closing and signing.
#include <fmt/format.h>

#include <utility>

#include "capture/capture.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "inspect/closing.hpp"
#include "inspect/inspector.hpp"
#include "inspect/marking.hpp"
#include "inspect/person_name.hpp"

namespace rva {
namespace {

std::string title(std::int64_t id) { return fmt::format("inspection {}", id); }

Decision with_round(Decision decision, const Inspection& inspection) {
  decision.round = inspection.final ? inspection.final->round : 0;
  return decision;
}

}  // namespace

void Inspector::decide(std::int64_t id, int comparison, int finding, const Decision& decision) {
  require_person(decision.person);
  require_unchanging(id, "wait, then decide on the new findings");
  records_.decide(id, comparison, finding, with_round(decision, inspection(id)));
}

void Inspector::decide_mark(std::int64_t id, int mark, const Decision& decision) {
  require_person(decision.person);
  require_unchanging(id, "wait, then decide");
  records_.decide_mark(id, mark, with_round(decision, inspection(id)));
}

void Inspector::decide_all(std::int64_t id, int comparison, std::vector<FindingDecision> decisions) {
  if (decisions.empty()) throw Error(title(id), "no decision was given", "choose the findings to decide on");
  require_unchanging(id, "wait, then decide on the new findings");
  const Inspection inspection = this->inspection(id);
  for (FindingDecision& one : decisions) {
    require_person(one.decision.person);
    one.decision = with_round(std::move(one.decision), inspection);
  }
  records_.decide_all(id, comparison, decisions);
}

int Inspector::mark(std::int64_t id, int comparison, int view, const Box& box, const Remark& remark) {
  const Inspection inspection = this->inspection(id);
  if (!inspection.comparison || inspection.comparison->number != comparison)
    throw Error(title(id), "was captured or compared again in the meantime",
                "mark it in the latest pictures");
  if (view < 0 || view >= static_cast<int>(inspection.views.size()))
    throw Error(title(id), fmt::format("has no view {}", view), "give one of its views, from 0");
  const InspectionFolder folder = this->folder(id);
  MarkedFinding marked =
      located_mark(*open_capture(folder.capture(Side::final, inspection, view, 0)), box, rig_.chain);
  marked.view = view;
  marked.comparison = comparison;
  marked.picture = review_picture(folder, inspection, view);
  return record_mark(inspection, std::move(marked), remark);
}

int Inspector::mark_in_picture(std::int64_t id, const MarkedFinding& marked, const ColorImage& picture,
                               const Remark& remark) {
  const Inspection inspection = this->inspection(id);
  require_person(remark.person);
  require_open(inspection);
  require_inside(marked.box, picture.width(), picture.height());
  MarkedFinding kept = marked;
  kept.picture = keep_picture(folder(id), InspectionFolder::marks_name, picture);
  return record_mark(inspection, std::move(kept), remark);
}

int Inspector::keep_snapshot(std::int64_t id, const ColorImage& picture, const Remark& remark) {
  require_person(remark.person);
  require_open(inspection(id));
  const std::string file = keep_picture(folder(id), InspectionFolder::snapshots_name, picture);
  return records_.add_snapshot(id, {0, file, remark.note, remark.person, iso_8601_now()});
}

int Inspector::record_mark(const Inspection& inspection, MarkedFinding marked, const Remark& remark) {
  require_person(remark.person);
  marked.round = inspection.final ? inspection.final->round : 0;
  marked.note = remark.note;
  marked.person = remark.person;
  marked.marked_at = iso_8601_now();
  return records_.add_mark(inspection.id, marked);
}

void Inspector::check_out(std::int64_t id, const std::vector<ListedItem>& items, const std::string& person) {
  require_person(person);
  for (const ListedItem& item : items) require_valid(item, title(id));
  records_.add_items(id, items, person, iso_8601_now());
}

void Inspector::state_item(std::int64_t id, int item, ItemStatement statement) {
  require_person(statement.person);
  statement.stated_at = iso_8601_now();
  records_.state_item(id, item, statement);
}

void Inspector::close(std::int64_t id, int comparison, const Remark& remark) {
  require_person(remark.person);
  tasks_.between_starts([&] {
    require_unchanging(id, "wait, then review the new findings");
    records_.close(id, {comparison, remark.person, remark.note, iso_8601_now()});
  });
}

void Inspector::sign(std::int64_t id, WritesPackage write) {
  tasks_.start(
      {.kind = TaskKind::signing, .inspection = id}, tasks_.ends_asked_for(), [&]() -> TaskRunner::Work {
        if (!inspection(id).closing) throw Error(title(id), "is not closed", "close it, then sign it");
        return [this, id, write = std::move(write)] { write(history(id), tasks_.counted_progress()); };
      });
}

void Inspector::remove(std::int64_t id) {
  tasks_.between_starts([&] {
    require_unchanging(id, "wait until that has finished");
    records_.remove(id);
  });
}

}  // namespace rva
