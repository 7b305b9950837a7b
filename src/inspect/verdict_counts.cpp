#include "inspect/verdict_counts.hpp"

namespace rva {

void VerdictCounts::add(Verdict verdict, std::size_t objects) {
  switch (verdict) {
    case Verdict::debris:
      debris += objects;
      break;
    case Verdict::debris_removed:
      removed += objects;
      break;
    case Verdict::debris_unreachable:
      unreachable += objects;
      break;
    case Verdict::installed_work:
      installed += objects;
      break;
    case Verdict::false_alarm:
      false_alarms += objects;
      break;
    case Verdict::second_look:
    case Verdict::undecided:
      undecided += objects;
      break;
  }
}

void VerdictCounts::count(const std::optional<Decision>& decision) {
  add(decision ? decision->verdict : Verdict::undecided, 1);
}

VerdictCounts& VerdictCounts::operator+=(const VerdictCounts& more) {
  debris += more.debris;
  removed += more.removed;
  unreachable += more.unreachable;
  installed += more.installed;
  false_alarms += more.false_alarms;
  undecided += more.undecided;
  return *this;
}

}  // namespace rva
