#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "comparisons/tables/studies/growth_table.hpp"
#include "tests/comparisons/tables/table_column.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(growth_test)

BOOST_AUTO_TEST_CASE(every_series_has_its_sizes_and_exponents,
                     *boost::unit_test::label("slow")) {
  const Table table = growth_table({4, 10}, {3, 10});
  std::map<std::string, std::vector<const TableRow*>> series;
  for (const TableRow& row : table.rows) {
    BOOST_TEST(row.cells.size() == table.columns.size());
    series[row.cells[0].text + ", " + row.cells[1].text].push_back(&row);
  }
  BOOST_TEST(series.size() == 12U);
  BOOST_TEST(table.notes.size() == 2U);  // nothing was left out
  const auto cells = column(table, "cells"), seconds = column(table, "seconds"),
             exponent = column(table, "time_exponent"),
             per_cell = column(table, "ns_per_cell");
  for (const auto& [name, rows] : series) {
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST_REQUIRE(rows.size() == 2U);
      const bool is_direct = name.ends_with("direct");
      const double few = *rows[0]->cells[cells].number,
                   many = *rows[1]->cells[cells].number;
      BOOST_TEST(few == (is_direct ? 27 : 64));
      BOOST_TEST(many == 1000);
      const double first = *rows[0]->cells[seconds].number,
                   last = *rows[1]->cells[seconds].number;
      BOOST_TEST(*rows[1]->cells[per_cell].number == 1e9 * last / many,
                 boost::test_tools::tolerance(1e-12));
      // With two sizes the fit is the slope between them.
      BOOST_TEST(*rows[1]->cells[exponent].number ==
                     std::log(last / first) / std::log(many / few),
                 boost::test_tools::tolerance(1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_would_take_too_long_is_named) {
  const Table table = growth_table({4, 10}, {3, 10}, 1e-9);
  const auto named = std::ranges::count_if(table.notes, [](const std::string& note) {
    return note.find(", 1000 cells: not run: may take ") < note.size();
  });
  BOOST_TEST(named == 12);
  BOOST_TEST(table.rows.size() == 12U);
}

BOOST_AUTO_TEST_CASE(what_would_not_fit_is_named) {
  const Table table = growth_table({4, 100000}, {100000});
  const auto named = std::ranges::count_if(table.notes, [](const std::string& note) {
    return note.ends_with("more memory than is left.");
  });
  BOOST_TEST(named == 12);  // of all series; of the direct ones nothing is left
  BOOST_TEST(table.rows.size() == 10U);
  for (const TableRow& row : table.rows)  // one size has no exponent
    BOOST_TEST(!row.cells[column(table, "time_exponent")].number.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
