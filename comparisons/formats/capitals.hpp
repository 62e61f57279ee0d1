#pragma once

#include <string>
#include <string_view>

namespace springcheck {

// Of letters without accents, whatever the locale.
std::string in_capitals(std::string_view text);
std::string in_small_letters(std::string_view text);

/// The first letter in capitals.
std::string capitalised(std::string_view text);

}  // namespace springcheck
