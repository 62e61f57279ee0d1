#pragma once

#include <string>

namespace springcheck {

/// Whether the bytes are UTF-8, as everything must be that goes into JSON and HDF5.
bool is_utf8(const std::string& text);

}  // namespace springcheck
