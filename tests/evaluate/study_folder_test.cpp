#include "evaluate/study_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "evaluate/evaluation_json.hpp"
#include "evaluate/moved_evaluation_json.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// None of these tests comes as far as an inspection.
class StudyFolderTest : public testing::Test {
 protected:
  void put(const nlohmann::ordered_json& evaluation) {
    write_file(folder_ / evaluation_file, json_file_text(evaluation));
  }
  void run() { static_cast<void>(run_study_in(where_, {}, subject_, {})); }
  void run_moved() { static_cast<void>(run_moved_study_in(where_, {}, subject_, {})); }

  test::TemporaryFolder folder_;
  StudyFolder where_{.path = folder_.path()};
  StudySubject subject_;
};

TEST_F(StudyFolderTest, AnEarlierEvaluationIsNotReplacedUnasked) {
  put(json_of(Evaluation{"", "d435", "", {}}));
  EXPECT_THROW(run(), ExistsError);
  EXPECT_THROW(run_moved(), ExistsError);
}

TEST_F(StudyFolderTest, IsResumedWithTheSubjectThatItWasBegunWith) {
  put(json_of(Evaluation{"", "correlation-9", "", {}}));
  where_.resume = true;
  EXPECT_THAT([&] { run(); }, ThrowsMessage<UsageError>(HasSubstr("another scene, bay or camera")));
  put(json_of(Evaluation{"", "d435", "dirt,cables", {}}));
  EXPECT_THAT([&] { run(); }, ThrowsMessage<UsageError>(HasSubstr("another scene, bay or camera")));
  put(json_of(std::vector<MovedInspection>{}, "return near, cameras d435"));
  EXPECT_THAT([&] { run_moved(); }, ThrowsMessage<UsageError>(HasSubstr("other options")));
}

TEST_F(StudyFolderTest, RefusesUnknownNames) {
  subject_.cameras = "gold";
  EXPECT_THROW(run(), UsageError);
  EXPECT_THROW(run_moved(), UsageError);
  subject_.cameras = "d435";
  subject_.bay = {"gold"};
  EXPECT_THROW(run(), UsageError);
  EXPECT_THROW(run_moved(), UsageError);
}

}  // namespace
}  // namespace rva
