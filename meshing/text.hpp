#pragma once

#include <string>
#include <string_view>

namespace springcheck {

/// Whether the bytes are UTF-8, as everything must be that goes into JSON and HDF5.
bool is_utf8(const std::string& text);

/// As far as it is printable and short, in quotes.
std::string quotation(std::string_view text);

}  // namespace springcheck
