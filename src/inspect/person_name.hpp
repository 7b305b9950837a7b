// Checks of the names of people, which are recorded with decisions.
#pragma once

#include <string>

namespace rva {

/// Whether a name is displayed as it was meant: valid UTF-8 with at least one letter or digit, without
/// invisible characters or characters that change the writing direction, and without leading, trailing or
/// repeated spaces.
[[nodiscard]] bool is_legible_name(const std::string& name);

/// @throws Error when a name is not legible
void require_person(const std::string& name);

/// Whether a legible name also consists only of letters, accents, digits, spaces and . ' ’ - and does not mix
/// scripts with similar letters, such as Latin and Cyrillic (Unicode Technical Standard 39, "highly
/// restrictive"). The name of an account must satisfy this.
[[nodiscard]] bool is_name_of_one_script(const std::string& name);

/// Whether two names look so similar that they can be confused (UTS 39, confusable skeletons, with and
/// without case folding); true for equal names.
[[nodiscard]] bool look_alike(const std::string& a, const std::string& b);

}  // namespace rva
