#pragma once

#include <string_view>

namespace springcheck {

/// A name that a user meets, and what it stands for: for `springcheck list`.
struct Described {
  std::string_view name, description;
  std::string_view unit{};  // empty: none
};

}  // namespace springcheck
