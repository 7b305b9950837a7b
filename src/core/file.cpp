#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "core/remains.hpp"

namespace rva {
namespace {

class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
  ~FileDescriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] int get() const { return descriptor_; }
  [[nodiscard]] int release() { return std::exchange(descriptor_, -1); }
  // A full disk may be reported only here.
  [[nodiscard]] bool close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return ::close(descriptor) == 0;
  }

 private:
  int descriptor_;
};

std::string reason() { return std::generic_category().message(errno); }

Error cannot_read(const std::filesystem::path& path) {
  const bool missing = errno == ENOENT;
  return {printable(path), missing ? "no such file" : fmt::format("cannot be read ({})", reason()),
          missing ? "check the path" : "check its permissions and the disk"};
}

Error cannot_write(const std::filesystem::path& path) {
  const bool full = errno == ENOSPC || errno == EDQUOT;
  return {printable(path), fmt::format("cannot be written ({})", reason()),
          full ? "free some space or choose another location"
               : "check the permissions or choose another location"};
}

// Without O_NONBLOCK, opening a pipe that has no writer would wait for ever.
int open_to_read(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

std::uintmax_t size_of_regular(const std::filesystem::path& path, const FileDescriptor& file) {
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) throw cannot_read(path);
  if (!S_ISREG(status.st_mode)) throw Error(printable(path), "not a file", "check the path");
  return static_cast<std::uintmax_t>(status.st_size);
}

FileDescriptor open_to_write(const std::filesystem::path& path, int flag) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flag, 0666));
  if (file.get() < 0) throw cannot_write(path);
  return file;
}

void write_all(const FileDescriptor& file, std::span<const std::byte> bytes,
               const std::filesystem::path& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ::ssize_t wrote = ::write(file.get(), bytes.data() + done, bytes.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) throw cannot_write(path);
    done += static_cast<std::size_t>(wrote);
  }
}

template <typename Bytes>
Bytes read_whole(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  const FileDescriptor file(open_to_read(path));
  const std::uintmax_t size = size_of_regular(path, file);
  if (size > max_bytes) {
    throw Error(printable(path),
                fmt::format("its size of {} MB is more than a file of this kind can have", size >> 20U),
                "check the path");
  }
  Bytes bytes;
  bytes.resize(size);
  std::size_t done = 0;
  while (done < size) {
    const ::ssize_t got = ::read(file.get(), bytes.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw cannot_read(path);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace

std::vector<std::byte> read_file(const std::filesystem::path& path) {
  return read_whole<std::vector<std::byte>>(path, max_file_bytes);
}

std::string read_text_file(const std::filesystem::path& path) {
  return read_whole<std::string>(path, max_text_bytes);
}

OpenFile::OpenFile(const std::filesystem::path& path) : path_(path), descriptor_(-1) {
  FileDescriptor file(open_to_read(path));
  size_bytes_ = size_of_regular(path, file);
  descriptor_ = file.release();
}

OpenFile::~OpenFile() { ::close(descriptor_); }

std::vector<std::byte> OpenFile::read(std::uint64_t at, std::size_t count) const {
  const std::uint64_t left = at < size_bytes_ ? size_bytes_ - at : 0;
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(count, left)));
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ::ssize_t got =
        ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<::off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw cannot_read(path_);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  FileDescriptor file = open_to_write(path, O_TRUNC);
  write_all(file, bytes, path);
  if (::fsync(file.get()) != 0 || !file.close()) throw cannot_write(path);
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file(path, std::as_bytes(std::span(text)));
}

void append_to_file(const std::filesystem::path& path, std::string_view text) {
  FileDescriptor file = open_to_write(path, O_APPEND);
  write_all(file, std::as_bytes(std::span(text)), path);
  if (!file.close()) throw cannot_write(path);
}

void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  replace_file(path, [&](const std::filesystem::path& partial) { write_file(partial, bytes); });
}

void replace_file(const std::filesystem::path& path, const WritesFile& write) {
  const std::filesystem::path source = std::filesystem::absolute(path);
  recover_remains(source, [](const std::filesystem::path& remains) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(std::filesystem::symlink_status(remains, ignored));
  });
  put_file(path, write);
  sync_folder(source.parent_path());
}

void put_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  put_file(path, [&](const std::filesystem::path& partial) { write_file(partial, bytes); });
}

void put_file(const std::filesystem::path& path, const WritesFile& write) {
  const std::filesystem::path partial = path.native() + fmt::format(".partial-{}", ::getpid());
  std::error_code ignored;
  try {
    write(partial);
  } catch (const Error& error) {
    std::filesystem::remove(partial, ignored);
    if (error.source() != printable(partial)) throw;
    throw Error(printable(path), error.problem(), error.remedy());
  } catch (...) {
    std::filesystem::remove(partial, ignored);
    throw;
  }
  if (::rename(partial.c_str(), path.c_str()) == 0) return;
  const Error failure = cannot_write(path);
  std::filesystem::remove(partial, ignored);
  throw failure;
}

}  // namespace rva
