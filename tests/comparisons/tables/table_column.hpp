#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "comparisons/formats/table.hpp"

namespace springcheck {

/// The place of a column in a table's rows.
inline std::size_t column(const Table& table, const std::string& key) {
  const auto found = std::ranges::find(table.columns, key, &Column::key);
  BOOST_TEST_REQUIRE((found != table.columns.end()), key);
  return static_cast<std::size_t>(found - table.columns.begin());
}

}  // namespace springcheck
