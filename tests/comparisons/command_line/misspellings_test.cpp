#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"
#include "comparisons/front/front_commands.hpp"
#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(misspellings_test)

namespace {

using Names = std::vector<std::string>;

/// The letters beside each on a keyboard.
char neighbour_of(char letter) {
  const std::string rows = "qwertyuiopqasdfghjklazxcvbnmz1234567890--_-";
  const std::size_t place = rows.find(letter);
  return place == rows.npos ? 'x' : rows[place + 1];
}

/// What people make of a name: a letter lost, doubled, swapped with the next, hit beside,
/// a hyphen forgotten or an underscore in its place.
Names misspellings_of(const std::string& name, std::size_t place) {
  const std::size_t i = place % name.size();
  Names all;
  all.push_back(name.substr(0, i) + name.substr(i + 1));
  all.push_back(name.substr(0, i) + name[i] + name.substr(i));
  if (i + 1 < name.size() && name[i] != name[i + 1]) {
    std::string swapped = name;
    std::swap(swapped[i], swapped[i + 1]);
    all.push_back(swapped);
  }
  std::string beside = name;
  beside[i] = neighbour_of(name[i]);
  all.push_back(beside);
  if (const std::size_t hyphen = name.find_first_of("-_"); hyphen != name.npos) {
    all.push_back(name.substr(0, hyphen) + name.substr(hyphen + 1));
    std::string other = name;
    other[hyphen] = name[hyphen] == '-' ? '_' : '-';
    all.push_back(other);
  }
  return all;
}

/// Every list of names that users write.
std::vector<Names> all_lists() {
  std::vector<Names> lists;
  Declarations all = declarations();
  add_front_commands(all);
  for (const auto& [list, entries] : all.lists.items()) {
    if (list == "exit-statuses" || list == "result-file") continue;
    Names& names = lists.emplace_back();
    for (const auto& entry : entries.items()) names.push_back(entry.key());
  }
  const auto commands = command_names(all);
  lists.emplace_back(commands.begin(), commands.end());
  const auto options = option_keys();
  lists.emplace_back(options.begin(), options.end());
  return lists;
}

}  // namespace

// A misspelling that is a name of the list, or of which one letter is left, tells
// nothing.
BOOST_AUTO_TEST_CASE(the_right_name_is_suggested_first) {
  std::size_t tried = 0, right = 0, place = 0;
  std::string wrong;
  for (const Names& names : all_lists()) {
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    for (const std::string& name : names)
      for (const std::string& misspelt : misspellings_of(name, ++place)) {
        if (misspelt.size() < 2 || std::ranges::count(names, misspelt) > 0) continue;
        ++tried;
        const std::string_view meant = nearest(misspelt, candidates);
        if (meant == name)
          ++right;
        else
          wrong += misspelt + " for " + name + ": " + std::string(meant) + "\n";
      }
  }
  BOOST_TEST_MESSAGE(right << " of " << tried << "\n" << wrong);
  BOOST_TEST(tried >= 200U);
  BOOST_TEST(static_cast<double>(right) >= 0.95 * static_cast<double>(tried), wrong);
}

BOOST_AUTO_TEST_SUITE_END()
