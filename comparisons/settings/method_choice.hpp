#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/settings/named_values.hpp"

namespace springcheck {

/// A method as users ask for it and tables call it: METHOD, or METHOD:ELEMENT of one that
/// reads an element.
struct MethodChoice {
  Method method;
  std::optional<ElementName> element{};  // none: that of the setting `element`
};

CaseSettings with_method(CaseSettings settings, const MethodChoice& choice);

/// The choice by a name in what was given. Throws InputError for an unknown method or
/// element.
MethodChoice method_choice(const Given& given, std::string_view name);

/// The choices by a list of names. Throws InputError where one is there twice.
std::vector<MethodChoice> method_choices(const Given& given);

/// The names of all choices, "fem-hooke" and "fem-hooke:q2".
template <>
std::vector<std::string_view> all_names<MethodChoice>();

}  // namespace springcheck
