#include "comparisons/names/suggestion.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(suggestion_test)

namespace {

/// The name with each letter lost, doubled, and swapped with the next.
std::vector<std::string> misspellings(std::string_view name) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < name.size(); ++i) {
    std::string lost(name), doubled(name), swapped(name);
    lost.erase(i, 1);
    doubled.insert(i, 1, name[i]);
    all.insert(all.end(), {lost, doubled});
    if (i + 1 < name.size() && name[i] != name[i + 1]) {
      std::swap(swapped[i], swapped[i + 1]);
      all.push_back(swapped);
    }
  }
  return all;
}

/// The share of misspellings, none of them a name itself, that lead back.
double share_of_right_ones(const std::vector<std::string_view>& names) {
  int right = 0, all = 0;
  for (const std::string_view name : names)
    for (const std::string& text : misspellings(name)) {
      if (std::ranges::count(names, text) > 0) continue;
      ++all;
      right += nearest(text, names) == name ? 1 : 0;
    }
  BOOST_TEST(all > 200);
  return static_cast<double>(right) / all;
}

}  // namespace

// There are more than a thousand misspellings of settings. Of methods, "mss-f" could be
// two, and "mss-d" as well.
BOOST_AUTO_TEST_CASE(misspelt_names_lead_back) {
  BOOST_TEST(share_of_right_ones(setting_keys()) >= 0.95);
  std::vector<std::string_view> names;
  for (const Method& method : methods()) names.emplace_back(method.name);
  BOOST_TEST(share_of_right_ones(names) >= 0.95);
}

BOOST_AUTO_TEST_CASE(fingers_swap_letters_more_than_they_exchange_them) {
  BOOST_TEST(nearest("mss-fc", {"mss-fd", "mss-cf"}) == "mss-cf");
  BOOST_TEST(nearest("FEM-StVK", {"fem-hooke", "fem-stvk"}) == "fem-stvk");
  BOOST_TEST(edit_distance("abc", "acb") == 2U);
  BOOST_TEST(edit_distance("abc", "abd") == 3U);
  BOOST_TEST(edit_distance("", "ab") == 4U);
}

BOOST_AUTO_TEST_CASE(the_only_name_that_begins_so_is_meant) {
  BOOST_TEST(nearest("deform", {"density", "deformation"}) == "deformation");
  BOOST_TEST(nearest("fem", {"fem-hooke", "fem-stvk"}).empty());
}

BOOST_AUTO_TEST_CASE(what_is_like_none_has_no_suggestion) {
  BOOST_TEST(nearest("colour", {"cells", "nu"}).empty());
  BOOST_TEST(nearest("", {"cells"}).empty());
  BOOST_TEST(nearest(std::string(10000, 'x'), {"cells"}).empty());
}

BOOST_AUTO_TEST_CASE(the_culprit_comes_first) {
  BOOST_CHECK_EXCEPTION(
      refuse_name("a.toml:1:1", "key", "cels", {"cells", "nu"}), InputError,
      [](const InputError& error) {
        return std::string(error.what()) ==
               "a.toml:1:1: unknown key 'cels', did you mean 'cells'? expected one of "
               "cells, nu";
      });
}

BOOST_AUTO_TEST_SUITE_END()
