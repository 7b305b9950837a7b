#include "core/path_text.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace rva {
namespace {

TEST(Utf8, AcceptsWellFormedText) {
  for (const char* text : {"", "plain", "Flügel", "翼", "🛩", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(is_utf8(text)) << text;
}

TEST(Utf8, RefusesWhatTheStandardRefuses) {
  // Lone continuation, overlong forms, a surrogate, beyond U+10FFFF, sequences that end early.
  for (const char* bytes : {"\x80", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                            "\xF5\x80\x80\x80", "\xE7\xBF", "a\xFF", "\xC3"}) {
    EXPECT_FALSE(is_utf8(bytes));
  }
}

TEST(Printable, StaysOneLineOfText) { EXPECT_EQ(printable("a\nb\x1b\xFF/ü"), "a\\x0Ab\\x1B\\xFF/ü"); }

TEST(Printable, IsAlwaysUtf8) {
  for (int first = 1; first < 256; ++first) {
    for (int second = 1; second < 256; ++second) {
      const std::string bytes{static_cast<char>(first), static_cast<char>(second)};
      ASSERT_TRUE(is_utf8(printable(bytes)));
    }
  }
}

TEST(RequireUtf8, NamesThePathItRefuses) {
  EXPECT_NO_THROW(require_utf8("/tmp/ü"));
  try {
    require_utf8("/tmp/\xFF");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.source(), "/tmp/\\xFF");
  }
}

}  // namespace
}  // namespace rva
