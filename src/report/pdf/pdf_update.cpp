#include "report/pdf/pdf_update.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace rva::pdf {
namespace {

Error damaged(std::string_view missing) {
  return {"PDF", fmt::format("cannot be extended, since it has no {}", missing),
          "write the HTML report, and report this as an error of RVA"};
}

// The number behind a key, also that of the first object which the key refers to.
std::size_t number_after(std::string_view text, std::string_view key) {
  const std::size_t found = text.find(key);
  const std::size_t digit =
      found == std::string_view::npos ? found : text.find_first_not_of(" [\r\n", found + key.size());
  std::size_t number = 0;
  if (digit == std::string_view::npos ||
      std::from_chars(text.data() + digit, text.data() + text.size(), number).ec != std::errc())
    throw damaged(key);
  return number;
}

}  // namespace

std::string text_string(const std::string& utf8) {
  std::u16string utf16;
  utf8::utf8to16(utf8.begin(), utf8.end(), std::back_inserter(utf16));
  std::string text = "<FEFF";
  for (const char16_t unit : utf16) text += fmt::format("{:04X}", static_cast<unsigned>(unit));
  return text + ">";
}

std::string time_string(const std::string& iso_8601) {
  constexpr std::size_t seconds = 19;
  std::string digits;
  for (const char character : iso_8601.substr(0, seconds))
    if (character >= '0' && character <= '9') digits += character;
  return fmt::format("(D:{}Z)", digits);
}

PdfUpdate::PdfUpdate(std::string file) : file_(std::move(file)) {
  constexpr std::string_view key = "startxref";
  const std::size_t end = file_.rfind(key);
  if (end == std::string::npos) throw damaged(key);
  last_table_ = number_after(std::string_view(file_).substr(end), key);
  read_table(last_table_);
}

// The newest table is read first; what earlier ones state about the same objects is outdated.
void PdfUpdate::read_table(std::size_t at) {
  constexpr std::size_t entry_size = 20;
  constexpr std::string_view begin = "xref";
  const std::string_view file(file_);
  if (at > file.size() || !file.substr(at).starts_with(begin)) throw damaged(begin);
  std::size_t line = file.find_first_of("0123456789", at);
  const std::size_t trailer = file.find("trailer", at);
  if (trailer == std::string_view::npos) throw damaged("trailer");
  while (line < trailer) {
    const std::size_t first = number_after(file.substr(line), "");
    const std::size_t count = number_after(file.substr(file.find(' ', line)), "");
    line = file.find('\n', line) + 1;
    for (std::size_t k = 0; k < count; ++k, line += entry_size)
      offsets_.try_emplace(static_cast<int>(first + k), number_after(file.substr(line, entry_size), ""));
  }
  const std::string_view stated = file.substr(trailer, file.find("startxref", trailer) - trailer);
  if (at == last_table_) {
    size_ = static_cast<int>(number_after(stated, "/Size"));
    catalog_ = static_cast<int>(number_after(stated, "/Root"));
    info_ = static_cast<int>(number_after(stated, "/Info"));
  }
  if (stated.find("/Prev") != std::string_view::npos) {
    const std::size_t earlier = number_after(stated, "/Prev");
    if (earlier >= at) throw damaged("earlier cross-reference table");
    read_table(earlier);
  }
}

std::string_view PdfUpdate::content_of(int object) const {
  const auto changed = changed_.find(object);
  if (changed != changed_.end()) return changed->second;
  const std::string_view file(file_);
  const auto known = offsets_.find(object);
  const std::size_t begin =
      known == offsets_.end() ? std::string_view::npos : file.find("obj", known->second);
  const std::size_t end = begin == std::string_view::npos ? begin : file.find("endobj", begin);
  if (end == std::string_view::npos) throw damaged(fmt::format("object {}", object));
  constexpr std::size_t keyword = 3;
  return file.substr(begin + keyword, end - begin - keyword);
}

int PdfUpdate::first_page() const {
  const auto pages = static_cast<int>(number_after(content_of(catalog_), "/Pages"));
  return static_cast<int>(number_after(content_of(pages), "/Kids"));
}

int PdfUpdate::add(const std::string& content) {
  changed_[size_] = content;
  return size_++;
}

void PdfUpdate::extend(int object, const std::string& entries) {
  std::string content(content_of(object));
  const std::size_t end = content.rfind(">>");
  if (end == std::string::npos) throw damaged(fmt::format("dictionary in object {}", object));
  content.insert(end, entries + " ");
  changed_[object] = content;
}

std::string PdfUpdate::finished() && {
  if (!file_.ends_with('\n')) file_ += '\n';
  std::string table = "xref\n";
  for (const auto& [number, content] : changed_) {
    table += fmt::format("{} 1\n{:010} 00000 n \n", number, file_.size());
    file_ += fmt::format("{} 0 obj\n{}\nendobj\n", number, content);
  }
  const std::size_t at = file_.size();
  file_ += fmt::format("{}trailer\n<< /Size {} /Root {} 0 R /Info {} 0 R /Prev {} >>\nstartxref\n{}\n%%EOF\n",
                       table, size_, catalog_, info_, last_table_, at);
  return std::move(file_);
}

}  // namespace rva::pdf
