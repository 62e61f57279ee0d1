#pragma once

#include <string_view>

namespace springcheck::tissue {

/// Throw InputError, naming the quantity and its unit in `name`, where a value is not a
/// finite number of the range.
void check_positive(std::string_view name, double value);
void check_not_negative(std::string_view name, double value);

}  // namespace springcheck::tissue
