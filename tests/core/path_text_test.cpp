#include "core/path_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva {
namespace {

struct Sequence {
  std::string_view bytes;
  bool well_formed;
};

// The first and last sequence of each row of table 3-7 of the Unicode Standard, and their neighbours beyond.
constexpr std::array<Sequence, 35> sequences{{{"\x7F", true},
                                              {"\x80", false},  // a continuation byte alone
                                              {"\xBF", false},
                                              {"\xC0\xAF", false},  // overlong form of '/'
                                              {"\xC1\xBF", false},
                                              {"\xC2\x80", true},
                                              {"\xC2\x7F", false},
                                              {"\xDF\xBF", true},
                                              {"\xDF\xC0", false},
                                              {"\xE0\x80\x80", false},  // overlong form of U+0000
                                              {"\xE0\x9F\xBF", false},
                                              {"\xE0\xA0\x80", true},
                                              {"\xEC\xBF\xBF", true},
                                              {"\xED\x9F\xBF", true},
                                              {"\xED\xA0\x80", false},              // the first surrogate
                                              {"\xED\xBF\xBF", false},              // the last one
                                              {"\xED\xA0\xBD\xED\xBB\xA9", false},  // a pair of surrogates
                                              {"\xEE\x80\x80", true},
                                              {"\xEF\xBF\xBE", true},  // noncharacters are well-formed
                                              {"\xEF\xBF\xBF", true},
                                              {"\xF0\x8F\xBF\xBF", false},  // overlong form of U+FFFF
                                              {"\xF0\x90\x80\x80", true},
                                              {"\xF3\xBF\xBF\xBF", true},
                                              {"\xF4\x8F\xBF\xBF", true},
                                              {"\xF4\x90\x80\x80", false},  // U+110000
                                              {"\xF5\x80\x80\x80", false},
                                              {"\xF8\x88\x80\x80\x80", false},  // five bytes
                                              {"\xFE", false},
                                              {"\xFF", false},
                                              {"\xC3", false},  // sequences that end early
                                              {"\xE7\xBF", false},
                                              {"\xF0\x9F\x9B", false},
                                              {"\xE7\xBF+", false},
                                              {"\xF0\x9F+", false},
                                              {"\xF0\x9F\x9B\xC3\xBC", false}}};

TEST(Utf8, AcceptsText) {
  for (const char* text : {"", "plain", "Flügel", "翼", "🛩"}) EXPECT_TRUE(is_utf8(text)) << text;
}

TEST(Utf8, AcceptsWellFormedSequencesOnly) {
  for (const Sequence& sequence : sequences) {
    EXPECT_EQ(is_utf8(sequence.bytes), sequence.well_formed) << testing::PrintToString(sequence.bytes);
    EXPECT_EQ(is_utf8(fmt::format("ü{}翼", sequence.bytes)), sequence.well_formed)
        << testing::PrintToString(sequence.bytes);
  }
}

TEST(Printable, StaysOneLineOfText) { EXPECT_EQ(printable("a\nb\x1b\xFF/ü"), "a\\x0Ab\\x1B\\xFF/ü"); }

TEST(Printable, EscapesEveryByteOfWhatItCannotShow) {
  EXPECT_EQ(printable("a\u202Egnp.exe"), "a\\xE2\\x80\\xAEgnp.exe");  // from right to left
  EXPECT_EQ(printable("\u05D0\u3042"), "\u05D0\u3042");
  EXPECT_EQ(printable("\xC2\x85"), "\\xC2\\x85");                // a control character of two bytes
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80");       // a surrogate
  EXPECT_EQ(printable("\xF0\x9F\xC3\xBC"), "\\xF0\\x9F\u00FC");  // a character after one that ends early
}

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
