#include "cli/config_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/option_flags.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ConfigFile : public testing::Test {
 protected:
  ConfigFile() {
    app_.add_option("--port", port_)->check(number_within(0, 65535));
    app_.add_option("--data", data_);
    app_.add_flag("--lamp", lamp_);
  }
  void apply(const std::string& text, std::vector<std::string> words = {}) {
    std::reverse(words.begin(), words.end());  // as CLI11 expects them
    app_.parse(words);
    write_file(folder_ / "rva.conf", text);
    apply_config_file(app_, (folder_ / "rva.conf").string());
  }
  template <typename Problem>
  std::string problem(const std::string& text) {
    try {
      apply(text);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "no such problem";
  }

  test::TemporaryFolder folder_;
  CLI::App app_{"", "serve"};
  int port_ = 8080;
  std::string data_ = "here";
  bool lamp_ = false;
};

TEST_F(ConfigFile, SetsWhatItStatesAndNothingElse) {
  apply("# a comment\n\nport = 81\nlamp = true\n");
  EXPECT_EQ(port_, 81);
  EXPECT_TRUE(lamp_);
  EXPECT_EQ(data_, "here");
}

TEST_F(ConfigFile, GivesWayToTheCommandLine) {
  apply("port = 81\ndata = \"/a folder/x\"\n", {"--port", "99"});
  EXPECT_EQ(port_, 99);
  EXPECT_EQ(data_, "/a folder/x");
}

TEST_F(ConfigFile, MayBeEmpty) { EXPECT_NO_THROW(apply("")); }

TEST_F(ConfigFile, RefusesOptionsThatTheCommandDoesNotHave) {
  EXPECT_THAT(problem<UsageError>("prot = 81\n"),
              AllOf(HasSubstr("rva.conf"), HasSubstr("prot is not an option of serve"),
                    HasSubstr("rva serve --help")));
  EXPECT_THAT(problem<UsageError>("[detect]\nport = 81\n"), HasSubstr("is not an option of serve"));
}

TEST_F(ConfigFile, RefusesValuesThatTheOptionRefuses) {
  EXPECT_THAT(problem<UsageError>("port = 65536\n"), AllOf(HasSubstr("rva.conf"), HasSubstr("65536")));
  EXPECT_THAT(problem<UsageError>("port = many\n"), HasSubstr("many"));
}

TEST_F(ConfigFile, NeedsTheFile) {
  EXPECT_THROW(apply_config_file(app_, (folder_ / "missing.conf").string()), Error);
  EXPECT_THROW(apply_config_file(app_, folder_.path().string()), Error);
}

}  // namespace
}  // namespace rva::cli
