// Records and accounts in one SQLite file.
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <mutex>

#include "inspect/records.hpp"
#include "server/accounts.hpp"

namespace rva {

/// Several programs may have the file open. Each change is one transaction, which is on the disk when it ends
/// (write-ahead log, full synchronisation).
class SqliteRecords : public Records, public Accounts {
 public:
  /// Creates the file if it does not exist.
  /// @throws Error when the file cannot be opened or created, belongs to another program, or was written by a
  ///         newer version of this one
  explicit SqliteRecords(const std::filesystem::path& file);

  [[nodiscard]] std::int64_t add_inspection(const InspectionOrder& order, const std::string& created_at,
                                            int dither, const std::vector<PanTilt>& views,
                                            std::int64_t above) override;
  [[nodiscard]] std::vector<std::int64_t> inspections() const override;
  [[nodiscard]] std::vector<InspectionSummary> summaries(const InspectionFilter& filter) const override;
  [[nodiscard]] std::vector<InspectionTally> tallies(const InspectionFilter& filter) const override;
  [[nodiscard]] std::optional<Inspection> find(std::int64_t id) const override;
  [[nodiscard]] std::optional<RecordedComparison> comparison(std::int64_t id, int number) const override;
  [[nodiscard]] std::vector<ComparedRound> rounds(std::int64_t id) const override;
  [[nodiscard]] std::optional<InspectionHistory> history(std::int64_t id) const override;
  void set_views(std::int64_t id, const std::vector<PanTilt>& views) override;
  void set_plan(std::int64_t id, int view, const Plan* plan) override;
  void set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) override;
  void begin_side(std::int64_t id, Side side, const BegunSide& begun) override;
  void set_side(std::int64_t id, Side side, const TakenSide& taken) override;
  void begin_comparison(std::int64_t id, const RecordedComparison& comparison) override;
  void set_comparison(std::int64_t id, const RecordedComparison& comparison,
                      const std::vector<ComparedView>& views,
                      const std::vector<ReviewedFinding>& findings) override;
  void decide(std::int64_t id, int comparison, int finding, const Decision& decision) override;
  [[nodiscard]] int add_mark(std::int64_t id, const MarkedFinding& marked) override;
  void add_items(std::int64_t id, const std::vector<ListedItem>& items, const std::string& person,
                 const std::string& taken_at) override;
  void state_item(std::int64_t id, int item, const ItemStatement& statement) override;
  [[nodiscard]] int add_snapshot(std::int64_t id, const Snapshot& snapshot) override;
  void decide_mark(std::int64_t id, int mark, const Decision& decision) override;
  void decide_all(std::int64_t id, int comparison, const std::vector<FindingDecision>& decisions) override;
  void close(std::int64_t id, const Closing& closing) override;
  void remove(std::int64_t id) override;
  void set_account(const Account& account) override;
  [[nodiscard]] std::vector<Account> accounts() const override;
  bool remove_account(const std::string& name) override;

 private:
  template <typename Work>
  auto change(const Work& work);
  template <typename Work>
  auto read(const Work& work) const;

  std::filesystem::path file_;
  std::string source_;
  mutable std::mutex mutex_;
  mutable SQLite::Database database_;  // a read may write the log
};

}  // namespace rva
