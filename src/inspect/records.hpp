// What outlives the program: inspections, decisions, accounts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// What somebody may do; each may do what those before it may.
enum class PersonRole {
  viewer,     ///< look, and stop the robot
  operator_,  ///< drive, take captures
  inspector,  ///< decide on findings
};
[[nodiscard]] std::string_view name_of(PersonRole role);
[[nodiscard]] std::optional<PersonRole> role_from_name(std::string_view name);

struct Account {
  std::string name;
  PersonRole role = PersonRole::viewer;
  std::string password_hash;  ///< as server/password.hpp makes it
  /// Another one whenever the account is added or changed: a sign-in belongs to it, not to the name. Made by
  /// the records, not by the caller.
  std::string generation{};
};

/// Every change is complete and on the disk when the call returns, or has not happened. Every member may be
/// called from any thread, and throws an Error when the disk or the database refuses.
class Records {
 public:
  Records() = default;
  virtual ~Records() = default;
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  /// @return its id
  /// @param dither captures of each view
  /// @param above  its id is larger
  [[nodiscard]] virtual std::int64_t add_inspection(const InspectionOrder& order,
                                                    const std::string& created_at, int dither,
                                                    const std::vector<PanTilt>& views,
                                                    std::int64_t above) = 0;
  /// Newest first.
  [[nodiscard]] virtual std::vector<std::int64_t> inspections() const = 0;
  /// Of all, newest first: much quicker than find() of each.
  [[nodiscard]] virtual std::vector<InspectionSummary> summaries() const = 0;
  /// Empty where there is none of this id.
  [[nodiscard]] virtual std::optional<Inspection> find(std::int64_t id) const = 0;

  // Of an inspection that is there; an Error otherwise.

  virtual void set_views(std::int64_t id, const std::vector<PanTilt>& views) = 0;
  /// A round of a side is under way from now on, until set_side() says that it is complete.
  virtual void begin_side(std::int64_t id, Side side, const BegunSide& begun) = 0;
  /// What was compared with an earlier capture holds no more.
  virtual void set_side(std::int64_t id, Side side, const TakenSide& taken) = 0;
  /// Takes the place of the polygons that were left out of this view before. What was compared without these
  /// holds no more.
  virtual void set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) = 0;
  /// A comparison is about to write into its folder.
  /// @param comparison with a number that no earlier one has
  virtual void begin_comparison(std::int64_t id, const RecordedComparison& comparison) = 0;
  /// Takes the place of an earlier comparison, which stays in the record with its findings and decisions.
  /// @param comparison with a number that no earlier one has
  virtual void set_comparison(std::int64_t id, const RecordedComparison& comparison,
                              const std::vector<ComparedView>& views,
                              const std::vector<ReviewedFinding>& findings) = 0;
  /// Earlier decisions are kept; the last one holds.
  /// @param comparison number of the comparison that found it
  /// @throws Error when there is no such finding, or it was compared anew since
  virtual void decide(std::int64_t id, int comparison, int finding, const Decision& decision) = 0;

  /// Adds an account or takes the place of the one of that name.
  virtual void set_account(const Account& account) = 0;
  [[nodiscard]] virtual std::vector<Account> accounts() const = 0;
  /// @return whether there was one
  virtual bool remove_account(const std::string& name) = 0;
};

}  // namespace rva
