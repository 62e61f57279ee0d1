#pragma once

#include <string>
#include <string_view>

namespace springcheck {

/// Whether the bytes are UTF-8, as everything must be that goes into JSON and HDF5.
bool is_utf8(const std::string& text);

/// The text in quotes, as far as it is printable and short.
std::string quotation(std::string_view text);

}  // namespace springcheck
