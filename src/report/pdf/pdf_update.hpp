// Additions to a PDF file that leave the bytes before them as they are.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace rva::pdf {

/// A text string in UTF-16, as hexadecimal digits, so that no text can end it. @param utf8 well-formed
[[nodiscard]] std::string text_string(const std::string& utf8);

/// The date "(D:20260101120000Z)" of "2026-01-01T12:00:00.000Z".
[[nodiscard]] std::string time_string(const std::string& iso_8601);

/// An incremental update (ISO 32000-1, section 7.5.6) of a file of this program.
class PdfUpdate {
 public:
  /// @param file with a cross-reference table of version 1.4
  /// @throws Error when it has none
  explicit PdfUpdate(std::string file);

  /// The numbers of objects.
  [[nodiscard]] int catalog() const { return catalog_; }
  [[nodiscard]] int info() const { return info_; }
  [[nodiscard]] int first_page() const;  ///< @throws Error when the file names none

  /// Adds an object. @return its number
  int add(const std::string& content);

  /// Puts another object in the place of one.
  void replace(int object, const std::string& content) { changed_[object] = content; }

  /// Adds entries to an object that is a dictionary, which must not have them.
  void extend(int object, const std::string& entries);

  /// The file with the update.
  [[nodiscard]] std::string finished() &&;

 private:
  void read_table(std::size_t at);
  [[nodiscard]] std::string_view content_of(int object) const;

  std::string file_;
  std::map<int, std::size_t> offsets_;  ///< of the objects in the file
  std::map<int, std::string> changed_;  ///< objects of the update
  std::size_t last_table_ = 0;
  int size_ = 0;  ///< the first number that no object has
  int catalog_ = 0;
  int info_ = 0;
};

}  // namespace rva::pdf
