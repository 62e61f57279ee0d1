#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "comparisons/sheets/sheet.hpp"

namespace springcheck {

/// The place of a column in a sheet's rows.
inline std::size_t column(const Sheet& sheet, const std::string& key) {
  const auto found = std::ranges::find(sheet.columns, key, &Column::key);
  BOOST_TEST_REQUIRE((found != sheet.columns.end()), key);
  return static_cast<std::size_t>(found - sheet.columns.begin());
}

}  // namespace springcheck
