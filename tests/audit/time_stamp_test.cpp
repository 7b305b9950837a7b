#include "audit/time_stamp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "audit/digest.hpp"
#include "audit/package_files.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/audit/sealed_package.hpp"

// What needs an authority is in tests/cli/time_stamp_test.py.
namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;

TEST(TimeStampRequest, ContainsTheDigestAloneAndANonce) {
  const std::string request = time_stamp_request("what was signed");
  EXPECT_THAT(request, HasSubstr(std::string(bytes_of(sha256("what was signed")))));
  EXPECT_THAT(request, testing::Not(HasSubstr("what was signed")));
  EXPECT_NE(request, time_stamp_request("what was signed"));
}

TEST(TimeStamp, OtherBytesAreNone) {
  const std::string request = time_stamp_request("what was signed");
  for (const std::string& text :
       {std::string(), std::string("<html>"), std::string("\x30\x80", 2), request}) {
    EXPECT_THROW(static_cast<void>(time_stamp_in(text, request, "server")), Error);
    EXPECT_THROW(static_cast<void>(check_time_stamp(text, "what was signed", {}, "token")), Error);
  }
}

class StampedPackage : public testing::Test {
 protected:
  // Seals a package with the answer of a server.
  void seal(const std::function<std::string(std::string_view)>& stamp) {
    PackageSigning signing = sealed_.signing();
    signing.time_stamping = {"http://time.example", stamp};
    sealed_.seal(package(), test::SealedPackage::payload(), signing);
  }
  [[nodiscard]] fs::path package() const { return sealed_.scratch(); }
  [[nodiscard]] std::string wrong(const KnownFromElsewhere& known = {}) const {
    try {
      static_cast<void>(check_package(package(), known));
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }

  test::SealedPackage sealed_;
};

TEST_F(StampedPackage, StatesWhyThereIsNoTimeStamp) {
  seal([](std::string_view) -> std::string { throw Error("server", "did not answer", "try again"); });
  const CheckedPackage checked = check_package(package(), {});
  ASSERT_TRUE(checked.statement.time_stamp.has_value());
  EXPECT_EQ(checked.statement.time_stamp->server, "http://time.example");
  EXPECT_EQ(checked.statement.time_stamp->failure, "did not answer");
  EXPECT_FALSE(checked.time_stamp.has_value());
  EXPECT_FALSE(fs::exists(package() / package_file::time_stamp));
  KnownFromElsewhere known;
  known.time_stamp_ca = package() / "bagit.txt";
  EXPECT_THAT(wrong(known), HasSubstr("did not answer"));
  write_file(package() / package_file::time_stamp, "added");
  EXPECT_THAT(wrong(), HasSubstr("was added"));
}

TEST_F(StampedPackage, StampsWhatIsInTheEnvelopeOfThePackage) {
  std::string stamped;
  seal([&](std::string_view bytes) {
    stamped = bytes;
    return std::string("token");
  });
  EXPECT_EQ(stamped, read_text_file(package() / package_file::envelope));
  EXPECT_THAT(wrong(), HasSubstr("is not a time stamp"));
  fs::remove(package() / package_file::time_stamp);
  EXPECT_THAT(wrong(), HasSubstr("there was a time stamp"));
}

// A program that is interrupted while it waits for the server leaves nothing in the log.
TEST_F(StampedPackage, IsStampedBeforeTheLogHasTheRecord) {
  seal([&](std::string_view) {
    EXPECT_EQ(read_log(sealed_.log(), sealed_.log_key().public_key()).leaves.size(), 3U);
    return std::string("token");
  });
  EXPECT_EQ(read_log(sealed_.log(), sealed_.log_key().public_key()).leaves.size(), 4U);
}

}  // namespace
}  // namespace rva
