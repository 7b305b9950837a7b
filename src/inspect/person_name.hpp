// Names of people, as they stand under decisions.
#pragma once

#include <string>

namespace rva {

/// A name that others read as it was meant: UTF-8, with at least one letter or digit, without characters that
/// cannot be seen or that turn the direction of writing, without spaces at its ends or in a row.
[[nodiscard]] bool is_legible_name(const std::string& name);

/// Such a name that mixes no scripts of which letters look alike, as Latin and Cyrillic ones do (Unicode
/// Technical Standard 39, "highly restrictive"): what the name of an account must be.
[[nodiscard]] bool is_name_of_one_script(const std::string& name);

/// Whether two names look so alike that one may be taken for the other (UTS 39, confusable skeletons, case
/// folded); true of equal ones.
[[nodiscard]] bool look_alike(const std::string& a, const std::string& b);

}  // namespace rva
