#include "server/sessions.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "server/password.hpp"
#include "store/sqlite_records.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

class SignIn : public testing::Test {
 protected:
  Sessions::Answer answer(const std::string& name, const std::string& password, double now_s = 0.0,
                          const std::string& from = "here") {
    return sessions_.sign_in(name, password, from, now_s).answer;
  }
  test::TemporaryFolder folder_;
  SqliteRecords records_{folder_ / "rva.db"};
  Sessions sessions_{records_};
};

TEST_F(SignIn, IsNeededOnceThereIsAnAccount) {
  EXPECT_FALSE(sessions_.needed());
  records_.set_account({"ann", PersonRole::inspector, hash_password("correct horse")});
  EXPECT_TRUE(sessions_.needed());
}

TEST_F(SignIn, AcceptsTheRightPassword) {
  records_.set_account({"ann", PersonRole::inspector, hash_password("correct horse")});
  EXPECT_EQ(answer("ann", "wrong horse"), Sessions::Answer::wrong);
  EXPECT_EQ(answer("bob", "correct horse"), Sessions::Answer::wrong);
  const Sessions::SignIn in = sessions_.sign_in("ann", "correct horse", "here", 10.0);
  ASSERT_EQ(in.answer, Sessions::Answer::signed_in);
  EXPECT_EQ(in.token.size(), 64U);
  EXPECT_EQ(sessions_.person(in.token, 11.0)->role, PersonRole::inspector);
  EXPECT_FALSE(sessions_.person(in.token + "0", 11.0));
  EXPECT_FALSE(sessions_.person("", 11.0));
  EXPECT_FALSE(sessions_.person(in.token, 10.0 + Sessions::lifetime_s)) << "a shift is over";
}

TEST_F(SignIn, EndsWithSignOutAndWithTheAccount) {
  records_.set_account({"ann", PersonRole::viewer, hash_password("correct horse")});
  const std::string a = sessions_.sign_in("ann", "correct horse", "here", 0.0).token;
  const std::string b = sessions_.sign_in("ann", "correct horse", "here", 0.0).token;
  EXPECT_NE(a, b);
  sessions_.sign_out(a);
  EXPECT_FALSE(sessions_.person(a, 1.0));
  EXPECT_TRUE(sessions_.person(b, 1.0));
  records_.set_account({"ann", PersonRole::operator_, hash_password("correct horse")});
  EXPECT_FALSE(sessions_.person(b, 1.0)) << "a new password or role ends sign-ins";
  const std::string c = sessions_.sign_in("ann", "correct horse", "here", 2.0).token;
  EXPECT_EQ(sessions_.person(c, 3.0)->role, PersonRole::operator_);
  records_.remove_account("ann");
  EXPECT_FALSE(sessions_.person(c, 3.0));
  records_.set_account({"ann", PersonRole::operator_, hash_password("correct horse")});
  EXPECT_FALSE(sessions_.person(c, 3.0)) << "an account of the same name is another one";
}

TEST_F(SignIn, GuessingIsSlowedDown) {
  records_.set_account({"ann", PersonRole::viewer, hash_password("correct horse")});
  for (int i = 0; i < Sessions::most_failures_of_name; ++i)
    EXPECT_EQ(answer("ann", "guess"), Sessions::Answer::wrong);
  EXPECT_EQ(answer("ann", "correct horse"), Sessions::Answer::too_many) << "even the right one";
  EXPECT_EQ(answer("ann", "correct horse", 0.0, "elsewhere"), Sessions::Answer::signed_in)
      << "wrong guesses lock nobody else out";
  EXPECT_EQ(answer("ann", "correct horse", Sessions::pause_s), Sessions::Answer::signed_in);
}

TEST_F(SignIn, GuessingManyNamesIsSlowedDownToo) {
  records_.set_account({"ann", PersonRole::viewer, hash_password("correct horse")});
  for (int i = 0; i < Sessions::most_failures_from; ++i)
    EXPECT_EQ(answer("name-" + std::to_string(i), "guess"), Sessions::Answer::wrong);
  EXPECT_EQ(answer("ann", "correct horse"), Sessions::Answer::too_many);
}

TEST_F(SignIn, GuessingFromManyAddressesIsSlowedDownToo) {
  records_.set_account({"ann", PersonRole::viewer, hash_password("correct horse")});
  for (int i = 0; i < Sessions::most_failures_of_name_from_all; ++i)
    EXPECT_EQ(answer("ann", "guess", 0.0, std::to_string(i)), Sessions::Answer::wrong);
  EXPECT_EQ(answer("ann", "correct horse"), Sessions::Answer::too_many);
}

TEST(Password, IsNotInItsHash) {
  const std::string hash = hash_password("correct horse");
  EXPECT_EQ(hash.find("horse"), std::string::npos);
  EXPECT_NE(hash, hash_password("correct horse")) << "salted";
  EXPECT_TRUE(is_password("correct horse", hash));
  EXPECT_FALSE(is_password("correct hors", hash));
  EXPECT_FALSE(is_password("correct horse", "no hash"));
  EXPECT_THROW(static_cast<void>(hash_password("short")), Error);
  EXPECT_THROW(static_cast<void>(hash_password(std::string(300, 'x'))), Error);
}

}  // namespace
}  // namespace rva
