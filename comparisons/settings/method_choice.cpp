#include "comparisons/settings/method_choice.hpp"

#include <algorithm>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

CaseSettings with_method(CaseSettings settings, const MethodChoice& choice) {
  settings.method = choice.method;
  if (choice.element) settings.elements.element = *choice.element;
  return settings;
}

MethodChoice method_choice(const Given& given, std::string_view name) {
  const std::size_t colon = std::min(name.find(':'), name.size());
  MethodChoice choice{.method = value_named<Method>(given, name.substr(0, colon))};
  if (colon == name.size()) return choice;
  if (!reads(choice.method, "element"))
    given.refuse(choice.method.name + " without ':': it has no elements to choose from");
  choice.element = value_named<ElementName>(given, name.substr(colon + 1));
  return choice;
}

std::vector<MethodChoice> method_choices(const Given& given) {
  std::vector<MethodChoice> all;
  const std::vector<std::string> names = given.texts();
  for (const std::string& name : names) {
    if (std::ranges::count(names, name) > 1)
      throw InputError(given.place(), "", "each name once", "'" + name + "' twice");
    all.push_back(method_choice(given, name));
  }
  return all;
}

template <>
std::vector<std::string_view> all_names<MethodChoice>() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Method& method : methods()) {
      all.push_back(method.name);
      if (reads(method, "element"))
        for (const ElementName& element : elements())
          if (std::ranges::count(method.refused_elements, element.name) == 0)
            all.push_back(method.name + ":" + std::string(element.name));
    }
    return all;
  }();
  return {names.begin(), names.end()};
}

}  // namespace springcheck
