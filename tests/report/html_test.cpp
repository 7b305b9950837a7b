#include "report/html.hpp"

#include <gtest/gtest.h>
#include <utf8.h>

#include <array>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rva {
namespace {

// What a browser shows of markup that has no elements.
std::string shown(std::string markup) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> entities{
      {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}};
  for (const auto& [entity, character] : entities)
    for (std::size_t at = markup.find(entity); at != std::string::npos; at = markup.find(entity, at + 1))
      markup.replace(at, entity.size(), character);
  return markup;
}

TEST(Html, TextIsShownAsItIs) {
  const std::string words = "<b onclick='x'>\"A&amp;B\"</b> 5 µm\n\tüber";
  EXPECT_EQ(shown(Html::text(words).str()), words);
  EXPECT_EQ(Html::text("<a&'\">").str(), "&lt;a&amp;&#39;&quot;&gt;");
}

TEST(Html, NoTextBecomesMarkup) {
  constexpr int trials = 2000;
  std::mt19937 random(1);
  const std::string likely = "<>&\"'/=-! \n\x01\x7f\xc3\xa9\xff\xed\xa0\x80\xef\xbf\xbe";
  for (int trial = 0; trial < trials; ++trial) {
    std::string bytes;
    for (auto length = random() % 40; length > 0; --length) bytes += likely[random() % likely.size()];
    const std::string markup = Html::text(bytes).str();
    EXPECT_EQ(markup.find_first_of("<>\"'"), std::string::npos) << markup;
    EXPECT_TRUE(utf8::is_valid(markup.begin(), markup.end()));
    EXPECT_EQ(markup.find_first_of("\x01\x7f"), std::string::npos);
    EXPECT_EQ(markup.find("\xef\xbf\xbe"), std::string::npos) << "U+FFFE is no character";
    EXPECT_EQ(Html::text(shown(markup)).str(), markup) << "what is shown is escaped to the same again";
  }
}

TEST(Html, BytesThatAreNoTextAreReplaced) {
  EXPECT_EQ(Html::text("a\xff"
                       "b")
                .str(),
            "a\xef\xbf\xbd"
            "b");
  EXPECT_EQ(Html::text(std::string_view("a\0b", 3)).str(),
            "a\xef\xbf\xbd"
            "b");
  EXPECT_EQ(Html::text("\xc2\x85").str(), "\xef\xbf\xbd") << "a control character of two bytes";
}

TEST(Html, ElementsContainWhatTheyAreGiven) {
  EXPECT_EQ(Html::element("p", Html::text("a") + Html::text("<")).str(), "<p>a&lt;</p>");
  EXPECT_EQ(Html::element("p", Html(), "open").str(), "<p class=\"open\"></p>");
  EXPECT_EQ(Html::typed("a<b").str(), "<bdi class=\"typed\">a&lt;b</bdi>");
  EXPECT_TRUE(Html().empty());
}

TEST(Html, APictureIsInTheDocument) {
  const std::array bytes{std::byte{0xff}, std::byte{0xd8}};
  EXPECT_EQ(Html::jpeg(bytes, "a \"view\"").str(),
            "<img alt=\"a &quot;view&quot;\" src=\"data:image/jpeg;base64,/9g=\">");
}

}  // namespace
}  // namespace rva
