#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>

namespace springcheck {

/// Every line of markdown has as many bars, every line of CSV as many commas.
inline void expect_rectangular(const std::string& markdown_text,
                               const std::string& csv_text, std::size_t rows,
                               const std::string& name) {
  std::istringstream markdown(markdown_text);
  std::set<std::ptrdiff_t> bars;
  for (std::string line; std::getline(markdown, line);)
    if (line.starts_with('|')) bars.insert(std::ranges::count(line, '|'));
  BOOST_TEST(bars.size() == 1U, name);

  std::istringstream csv(csv_text);
  std::set<std::ptrdiff_t> commas;
  std::size_t lines = 0;
  for (std::string line; std::getline(csv, line); ++lines) {
    bool in_quotes = false;
    std::ptrdiff_t count = 0;
    for (const char c : line) {
      if (c == '"') in_quotes = !in_quotes;
      count += c == ',' && !in_quotes;
    }
    commas.insert(count);
  }
  BOOST_TEST(commas.size() == 1U, name);
  BOOST_TEST(lines == rows + 1);
}

}  // namespace springcheck
