#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/cases/body.hpp"
#include "comparisons/formats/table.hpp"
#include "comparisons/tables/catalogue.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(theory_tables_test)

namespace {

Table table_of(const std::string& name) {
  const TablePlan plan = plan_of(table_named(name));
  BOOST_TEST(plan.requests.empty());
  BOOST_TEST((table_named(name).source == Source::when_printed));
  MeshStore meshes;
  Table table = plan.make({}, meshes);
  for (const TableRow& row : table.rows)
    BOOST_TEST_REQUIRE(row.cells.size() == table.columns.size());
  for (const TableFormat format :
       {TableFormat::markdown, TableFormat::csv, TableFormat::json, TableFormat::latex})
    BOOST_TEST(!format_table(table, format).empty());
  return table;
}

const Cell& cell(const Table& table, const TableRow& row, const std::string& key) {
  const auto column = std::ranges::find(table.columns, key, &Column::key);
  BOOST_TEST_REQUIRE((column != table.columns.end()), key);
  return row.cells[static_cast<std::size_t>(column - table.columns.begin())];
}

double number(const Table& table, const TableRow& row, const std::string& key) {
  return cell(table, row, key).number.value();
}

}  // namespace

// Kinds of loss that the tests of the lattice know: zigzags at small A, long waves at
// large, in tension at nu = 0 the sides, at nu = 1/4 nothing.
BOOST_AUTO_TEST_CASE(the_lattice_s_table_names_each_loss_with_its_wave,
                     *boost::unit_test::label("slow")) {
  const Table table = table_of("lattice-stability");
  const auto find = [&](double A, double nu) -> const TableRow& {
    return *std::ranges::find_if(table.rows, [&](const TableRow& row) {
      return number(table, row, "diagonal_ratio") == A && number(table, row, "nu") == nu;
    });
  };
  const auto text = [&](double A, double nu, const char* key) {
    return cell(table, find(A, nu), key).text;
  };
  BOOST_TEST(cell(table, find(0, 0.25), "method").text == "mss-nfd");
  BOOST_TEST(text(0, 0.25, "compression_loss") == "wrinkle");
  BOOST_TEST(number(table, find(0, 0.25), "compression_strain") < 1e-4);

  BOOST_TEST(std::abs(number(table, find(0.1, 0), "compression_strain") - 7.06) < 0.01);
  BOOST_TEST(text(0.1, 0, "compression_wave") == "1 0 1");
  BOOST_TEST(std::abs(number(table, find(0.1, 0), "compression_wavelength") -
                      std::sqrt(2.)) < 1e-3);

  BOOST_TEST(text(10, 0, "compression_loss") == "long waves");
  BOOST_TEST(text(10, 0, "compression_wavelength") == "infinite");
  BOOST_TEST(!cell(table, find(10, 0), "compression_wavelength").number);
  BOOST_TEST(text(10, 0.25, "compression_wave") == "0 0 1");

  BOOST_TEST(std::abs(number(table, find(1, 0), "tension_strain") - 19.45) < 0.01);
  BOOST_TEST(text(1, 0, "tension_loss") == "free sides");
  BOOST_TEST(text(1, 0.25, "tension_loss") == "nothing");
  BOOST_TEST(text(1, 0.25, "tension_strain") == "> 100");
  BOOST_TEST(!cell(table, find(1, 0.25), "tension_strain").number);
}

// Found by stepping and on paper: the bisection's 1e-12 and what a grazing border makes
// of it.
BOOST_AUTO_TEST_CASE(the_regions_borders_are_those_on_paper) {
  const Table table = table_of("regions");
  std::size_t points = 0;
  for (const TableRow& row : table.rows) {
    BOOST_TEST(std::abs(number(table, row, "border") - number(table, row, "on_paper")) <
               1e-10);
    const double zeta = number(table, row, "zeta");
    if (zeta > 1) continue;
    ++points;
    BOOST_TEST(std::hypot(number(table, row, "real"), number(table, row, "imaginary")) ==
                   number(table, row, "border"),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST((number(table, row, "real") > 0) == (zeta < 0));
  }
  BOOST_TEST(points == 2U * 12 + 13 + 2 * 11);
}

BOOST_AUTO_TEST_CASE(the_four_springs_table_is_figure_3_2) {
  const Table table = table_of("four-springs");
  std::size_t jumps = 0;
  const TableRow* before = nullptr;
  for (const TableRow& row : table.rows) {
    for (const char* key : {"force", "centre"})
      BOOST_TEST(std::abs(number(table, row, key) -
                          number(table, row, std::string(key) + "_on_paper")) < 1e-6);
    const bool goes_on = before != nullptr && cell(table, *before, "part").text != "held";
    if (goes_on &&
        std::abs(number(table, row, "zeta") - number(table, *before, "zeta")) > 1)
      ++jumps;
    before = &row;
  }
  BOOST_TEST(jumps == 3U);  // inverted, upright, inverted again
}

BOOST_AUTO_TEST_SUITE_END()
