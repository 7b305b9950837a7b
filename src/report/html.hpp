// Markup of a report. Text becomes markup only by being escaped, so that nothing that a person typed, and no
// name of a file, is taken for markup.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace rva {

/// A piece of an HTML document.
class Html {
 public:
  /// Nothing.
  Html() = default;

  /// Text as it is read. @see shown_text() for what becomes of bytes that are no text
  [[nodiscard]] static Html text(std::string_view words);
  /// Text of a person. Its direction of writing does not affect what follows it, and its line breaks are
  /// kept.
  [[nodiscard]] static Html typed(std::string_view words);
  /// An element. @param name, class_name from the program, not from outside; no class where it is empty
  [[nodiscard]] static Html element(std::string_view name, const Html& content,
                                    std::string_view class_name = {});
  /// A picture within the document. @param description for those who do not see it
  [[nodiscard]] static Html jpeg(std::span<const std::byte> jpeg, std::string_view description);
  /// Markup of the program, not from outside.
  [[nodiscard]] static Html markup(std::string_view written);

  Html& operator+=(const Html& more);
  [[nodiscard]] friend Html operator+(Html first, const Html& second) { return first += second; }

  [[nodiscard]] const std::string& str() const { return markup_; }
  [[nodiscard]] bool empty() const { return markup_.empty(); }

 private:
  std::string markup_;
};

}  // namespace rva
