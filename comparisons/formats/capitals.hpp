#pragma once

#include <string>
#include <string_view>

namespace springcheck {

// The text in capitals or in small letters. Only letters without accents change, whatever
// the locale.
std::string in_capitals(std::string_view text);
std::string in_small_letters(std::string_view text);

/// The first letter in capitals.
std::string capitalised(std::string_view text);

}  // namespace springcheck
