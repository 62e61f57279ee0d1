#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "comparisons/studies/study.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "tests/comparisons/tables/table_column.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(tissue_table_test)

// The bands that tissue is to hold for three organs and rates: 1 % root mean square of
// ln, 2 % at most. The thesis's force, which no rate changes, is off the fastest by more.
BOOST_AUTO_TEST_CASE(springs_follow_the_law_where_the_thesiss_force_does_not) {
  const TablePlan plan = plan_of(table_named("tissue"));
  MeshStore meshes;
  const std::vector<CaseResult> results =
      run_study(plan.requests, meshes, 2, [](std::size_t, std::size_t) {});
  const Table table = plan.make(results, meshes);
  BOOST_TEST(table.rows.size() == 81U);
  std::map<std::pair<std::string, double>, std::pair<double, int>> squares;
  double thesis_at_fastest = 0;
  for (const TableRow& row : table.rows) {
    BOOST_TEST_REQUIRE(row.cells.size() == table.columns.size());
    const double off = row.cells[column(table, "springs_off")].number.value();
    BOOST_TEST(std::abs(off) < 2);
    const double rate = *row.cells[column(table, "rate")].number;
    auto& [sum, count] = squares[{row.cells[0].text, rate}];
    sum += std::pow(std::log(1 + off / 100), 2);
    ++count;
    // The law and the deviation give the stress to the table's digits.
    const double law = *row.cells[column(table, "law")].number;
    BOOST_TEST(*row.cells[column(table, "springs")].number == law * (1 + off / 100),
               boost::test_tools::tolerance(1e-12));
    if (rate == 0.67)
      thesis_at_fastest = std::max(
          thesis_at_fastest, std::abs(*row.cells[column(table, "thesis_off")].number));
    BOOST_TEST(!row.cases.empty());
  }
  BOOST_TEST(squares.size() == 9U);
  for (const auto& [what, sum] : squares)
    BOOST_TEST(std::sqrt(sum.first / sum.second) < 0.01, what.first << what.second);
  BOOST_TEST(thesis_at_fastest > 30);
}

BOOST_AUTO_TEST_SUITE_END()
