// The exceptions by which the library reports errors: each is a sentence for the user.
#pragma once

#include <stdexcept>
#include <string>

namespace rva {

/// Something outside the program is wrong: a file, a device or the value of an option.
///
/// Policy: a call that throws leaves its arguments and the disk as they were. Programming mistakes are
/// assertions, not Errors. `what()` is one line, `source: problem; remedy`, fit for stderr as it is.
class Error : public std::runtime_error {
 public:
  /// @param source   where: a path (see printable()), an option, a device
  /// @param problem what is wrong there, without a full stop
  /// @param remedy  what the user can do about it, as an instruction
  Error(std::string source, std::string problem, std::string remedy);

  /// The path, option or device that is wrong.
  [[nodiscard]] const std::string& source() const { return source_; }
  /// What is wrong with it, without a full stop.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// An instruction for the user.
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

 private:
  std::string source_;
  std::string problem_;
  std::string remedy_;
};

/// An argument or option is out of range, or does not go with the others; `rva` exits with status 2 on it.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace rva
