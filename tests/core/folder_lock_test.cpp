#include "core/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>

#include "core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;

class FolderLockTest : public testing::Test {
 protected:
  FolderLockTest() { fs::create_directory(path_); }

  [[nodiscard]] std::string error() const {
    try {
      const FolderLock lock(path_);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  fs::path path_ = folder_ / "records";
};

/// Another process, which is killed at the end.
class Process {
 public:
  /// @param work called in the process, which then waits
  template <typename Work>
  explicit Process(const Work& work) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    id_ = ::fork();
    if (id_ == 0) {
      const char done = work() ? 'y' : 'n';
      if (::write(ends[1], &done, 1) == 1) ::pause();
      ::_exit(0);
    }
    ::close(ends[1]);
    char done = 'n';
    succeeded_ = ::read(ends[0], &done, 1) == 1 && done == 'y';
    ::close(ends[0]);
  }
  ~Process() { kill(); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] bool succeeded() const { return succeeded_; }
  void kill() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    id_ = 0;
  }

 private:
  pid_t id_ = 0;
  bool succeeded_ = false;
};

TEST_F(FolderLockTest, IsHadByOneAtATime) {
  {
    const FolderLock lock(path_);
    EXPECT_THAT(error(), HasSubstr("records: is used by another rva"));
    EXPECT_EQ(FolderLock::try_lock(path_), nullptr);
    EXPECT_NE(FolderLock::try_lock(folder_.path()), nullptr) << "the folder around it is another folder";
  }
  EXPECT_EQ(error(), "no error");
  auto tried = FolderLock::try_lock(path_);
  EXPECT_NE(tried, nullptr);
  EXPECT_THAT(error(), HasSubstr("is used by another rva"));
  EXPECT_EQ(FolderLock::try_lock(path_), nullptr) << "a vain attempt must not release the lock";
  tried.reset();
  EXPECT_EQ(error(), "no error");
}

TEST_F(FolderLockTest, OfAKilledProgramIsReleased) {
  std::unique_ptr<FolderLock> in_process;
  Process process([&] { return (in_process = FolderLock::try_lock(path_)) != nullptr; });
  ASSERT_TRUE(process.succeeded());
  EXPECT_THAT(error(), HasSubstr("is used by another rva"));
  process.kill();
  EXPECT_EQ(error(), "no error");
}

TEST_F(FolderLockTest, IsNotLeftToAProgramThatWasStartedMeanwhile) {
  auto lock = FolderLock::try_lock(path_);
  ASSERT_NE(lock, nullptr);
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t id = ::fork();
  if (id == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl("/bin/sh", "sh", "-c", "echo; exec sleep 600", nullptr);
    ::_exit(1);
  }
  char started = 0;
  EXPECT_EQ(::read(ends[0], &started, 1), 1);
  lock.reset();
  EXPECT_EQ(error(), "no error");
  ::kill(id, SIGKILL);
  ::waitpid(id, nullptr, 0);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(FolderLockTest, FollowsTheFolderToItsNewName) {
  const FolderLock lock(path_);
  fs::rename(path_, folder_ / "moved");
  EXPECT_EQ(FolderLock::try_lock(folder_ / "moved"), nullptr);
  fs::create_directory(path_);
  EXPECT_EQ(error(), "no error");
}

TEST_F(FolderLockTest, NeedsAFolder) {
  fs::remove(path_);
  EXPECT_THAT(error(), HasSubstr("cannot be opened (No such file or directory)"));
  EXPECT_EQ(FolderLock::try_lock(path_), nullptr);
  std::ofstream(path_) << "a file";
  EXPECT_THAT(error(), HasSubstr("cannot be opened (Not a directory)"));
  EXPECT_EQ(FolderLock::try_lock(path_), nullptr);
}

}  // namespace
}  // namespace rva
