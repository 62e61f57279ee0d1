#include "comparisons/sheets/sheet.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(sheet_test)

// A number of any kind, a text, either one lacking; signs where a column has them, with
// all digits too.
BOOST_AUTO_TEST_CASE(cells_are_made_of_values) {
  const std::optional<double> none;
  const std::string_view word = "ok";
  const Sheet sheet{.name = "sheet",
                    .title = "Cells",
                    .columns = {{"name", "name"},
                                {"count", "count", "{:.0f}"},
                                {"off", "off [%]", "{:.1f}", true},
                                {"order", "order", "{:.2f}"}},
                    .rows = {{.cells = {"a", 3, 1.25, {none, "no order"}}},
                             {.cells = {std::string("b"), 4U, -0.5, 2.}},
                             {.cells = {word, {}, none, 1.5}}}};
  BOOST_TEST(format_sheet(sheet, TableFormat::csv) ==
             "name,count,off [%],order,notes,case\n"
             "a,3,+1.25,no order,,\n"
             "b,4,-0.5,2,,\n"
             "ok,,,1.5,,\n");
  BOOST_TEST(sheet_in_columns(sheet, {"order"}).find("+1.2") != std::string::npos);
}

// A bar would end the cell, a line's end the table.
BOOST_AUTO_TEST_CASE(cells_of_markdown_stay_cells) {
  const Sheet sheet{.name = "sheet",
                    .title = "Cells",
                    .columns = {{"name", "a|b"}, {"other", "other"}},
                    .rows = {{.cells = {"one|two\nthree", "x"}}}};
  BOOST_TEST(format_sheet(sheet, TableFormat::markdown) ==
             "## Cells\n\n"
             "| a\\|b | other |\n| --- | --- |\n"
             "| one\\|two three | x |\n");
}

BOOST_AUTO_TEST_SUITE_END()
