#include "inspect/person_name.hpp"

#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/uspoof.h>

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

bool is_hidden(UChar32 character) {
  switch (u_charType(character)) {
    case U_CONTROL_CHAR:
    case U_FORMAT_CHAR:
    case U_SURROGATE:
    case U_PRIVATE_USE_CHAR:
    case U_UNASSIGNED:
    case U_LINE_SEPARATOR:
    case U_PARAGRAPH_SEPARATOR:
      return true;
    case U_SPACE_SEPARATOR:
      return character != ' ';
    default:
      return u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT) != 0;
  }
}

bool has_loose_spaces(const std::string& name) {
  return name.starts_with(' ') || name.ends_with(' ') || name.find("  ") != std::string::npos;
}

using Checker = std::unique_ptr<USpoofChecker, decltype(&uspoof_close)>;

Checker make_checker(URestrictionLevel level, int checks) {
  UErrorCode status = U_ZERO_ERROR;
  Checker checker(uspoof_open(&status), uspoof_close);
  uspoof_setRestrictionLevel(checker.get(), level);
  uspoof_setChecks(checker.get(), checks, &status);
  if (U_FAILURE(status)) throw Error("names", "cannot be checked (ICU)", "reinstall ICU's data");
  return checker;
}

icu::UnicodeString as_written(const std::string& name) { return icu::UnicodeString::fromUTF8(name); }

// Names that differ only in case, such as "Ann" and "ann", can be confused.
icu::UnicodeString folded(const std::string& name) { return as_written(name).foldCase(); }

icu::UnicodeString skeleton_of(const icu::UnicodeString& text) {
  const Checker checker = make_checker(USPOOF_HIGHLY_RESTRICTIVE, USPOOF_CONFUSABLE);
  UErrorCode status = U_ZERO_ERROR;
  icu::UnicodeString skeleton;
  uspoof_getSkeletonUnicodeString(checker.get(), 0, text, skeleton, &status);
  return U_FAILURE(status) ? text : skeleton;
}

// Whether a character may occur in the name of an account: letters, their accents, digits, and what joins the
// parts of a name. A combining overlay is not allowed, since it hides the character below it.
bool is_of_names(UChar32 character) {
  constexpr UChar32 first_overlay = 0x0334;
  constexpr UChar32 last_overlay = 0x0338;
  if (character >= first_overlay && character <= last_overlay) return false;
  const std::int8_t type = u_charType(character);
  return u_isalpha(character) != 0 || u_isdigit(character) != 0 || type == U_NON_SPACING_MARK ||
         type == U_COMBINING_SPACING_MARK ||
         std::u32string_view(U" .'\u2019-").find(static_cast<char32_t>(character)) !=
             std::u32string_view::npos;
}

// Full-width, superscript or circled letters (compatibility characters) imitate others.
bool has_disguised_letters(const icu::UnicodeString& text) {
  UErrorCode status = U_ZERO_ERROR;
  const icu::UnicodeString plain = icu::Normalizer2::getNFKCInstance(status)->normalize(text, status);
  const icu::UnicodeString composed = icu::Normalizer2::getNFCInstance(status)->normalize(text, status);
  return U_FAILURE(status) || plain != composed;
}

}  // namespace

bool is_legible_name(const std::string& name) {
  if (!is_utf8(name) || has_loose_spaces(name)) return false;
  const icu::UnicodeString text = icu::UnicodeString::fromUTF8(name);
  bool legible = false;
  for (int at = 0; at < text.length(); at = text.moveIndex32(at, 1)) {
    const UChar32 character = text.char32At(at);
    if (is_hidden(character)) return false;
    legible = legible || u_isalnum(character) != 0;
  }
  return legible;
}

void require_person(const std::string& name) {
  if (!is_legible_name(name)) throw Error("person", "no name was given", "enter your name");
}

bool is_name_of_one_script(const std::string& name) {
  if (!is_legible_name(name)) return false;
  const icu::UnicodeString text = as_written(name);
  for (int at = 0; at < text.length(); at = text.moveIndex32(at, 1)) {
    if (!is_of_names(text.char32At(at))) return false;
  }
  if (has_disguised_letters(text)) return false;
  const Checker checker = make_checker(USPOOF_HIGHLY_RESTRICTIVE,
                                       USPOOF_RESTRICTION_LEVEL | USPOOF_INVISIBLE | USPOOF_MIXED_NUMBERS);
  UErrorCode status = U_ZERO_ERROR;
  const int problems = uspoof_checkUnicodeString(checker.get(), text, nullptr, &status);
  return U_SUCCESS(status) && problems == 0;
}

bool look_alike(const std::string& a, const std::string& b) {
  return a == b || skeleton_of(as_written(a)) == skeleton_of(as_written(b)) ||
         skeleton_of(folded(a)) == skeleton_of(folded(b));
}

}  // namespace rva
