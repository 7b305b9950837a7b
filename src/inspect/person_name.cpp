#include "inspect/person_name.hpp"

#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/uspoof.h>

#include <memory>

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
  if (U_FAILURE(status)) throw Error("names", "cannot be checked (ICU)", "install ICU's data again");
  return checker;
}

// What a name looks like. Capitals look like small letters here: "Ann" and "ann" are taken for each other.
icu::UnicodeString skeleton_of(const std::string& name) {
  const Checker checker = make_checker(USPOOF_HIGHLY_RESTRICTIVE, USPOOF_CONFUSABLE);
  UErrorCode status = U_ZERO_ERROR;
  icu::UnicodeString folded = icu::UnicodeString::fromUTF8(name);
  folded.foldCase();
  icu::UnicodeString skeleton;
  uspoof_getSkeletonUnicodeString(checker.get(), 0, folded, skeleton, &status);
  return U_FAILURE(status) ? folded : skeleton.foldCase();
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

bool is_name_of_one_script(const std::string& name) {
  if (!is_legible_name(name)) return false;
  const Checker checker = make_checker(USPOOF_HIGHLY_RESTRICTIVE,
                                       USPOOF_RESTRICTION_LEVEL | USPOOF_INVISIBLE | USPOOF_MIXED_NUMBERS);
  UErrorCode status = U_ZERO_ERROR;
  const int problems =
      uspoof_checkUnicodeString(checker.get(), icu::UnicodeString::fromUTF8(name), nullptr, &status);
  return U_SUCCESS(status) && problems == 0;
}

bool look_alike(const std::string& a, const std::string& b) {
  return a == b || skeleton_of(a) == skeleton_of(b);
}

}  // namespace rva
