#include "comparisons/formats/table.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(table_test)

// A number of any kind, a text, either one lacking; signs where a column has them, with
// all digits too.
BOOST_AUTO_TEST_CASE(cells_are_made_of_values) {
  const std::optional<double> none;
  const std::string_view word = "ok";
  const Table table{.name = "table",
                    .title = "Cells",
                    .columns = {{"name", "name"},
                                {"count", "count", "{:.0f}"},
                                {"off", "off [%]", "{:.1f}", true},
                                {"order", "order", "{:.2f}"}},
                    .rows = {{.cells = {"a", 3, 1.25, {none, "no order"}}},
                             {.cells = {std::string("b"), 4U, -0.5, 2.}},
                             {.cells = {word, {}, none, 1.5}}}};
  BOOST_TEST(format_table(table, TableFormat::csv) ==
             "name,count,off [%],order,notes,case\n"
             "a,3,+1.25,no order,,\n"
             "b,4,-0.5,2,,\n"
             "ok,,,1.5,,\n");
  BOOST_TEST(table_in_columns(table, {}, {"order"}).find("+1.2") != std::string::npos);
}

// A bar would end the cell, a line's end the table.
BOOST_AUTO_TEST_CASE(cells_of_markdown_stay_cells) {
  const Table table{.name = "table",
                    .title = "Cells",
                    .columns = {{"name", "a|b"}, {"other", "other"}},
                    .rows = {{.cells = {"one|two\nthree", "x"}}}};
  BOOST_TEST(format_table(table, TableFormat::markdown) ==
             "## Cells\n\n"
             "| a\\|b | other |\n| --- | --- |\n"
             "| one\\|two three | x |\n");
}

// Print is narrower than screens, and JSON has values where tables have words.
BOOST_AUTO_TEST_CASE(print_and_json_have_columns_and_values_of_their_own) {
  const Table table{
      .name = "table",
      .title = "Two columns",
      .columns = {{"a", "alpha"},
                  {.key = "b", .heading = "beta", .format = "{}", .in_print = false},
                  {"c", "gamma"}},
      .rows = {{.cells = {"x", 1.5, "z"}, .in_json = {{"c", {1, 2}}, {"d", "more"}}}},
      .in_json = {{"unit", "m"}}};
  const auto json = nlohmann::json::parse(format_table(table, TableFormat::json));
  BOOST_TEST(json["unit"] == "m");
  const auto& row = json["rows"][0];
  BOOST_TEST(row["a"] == "x");
  BOOST_TEST(row["b"] == 1.5);
  BOOST_TEST((row["c"] == nlohmann::json{1, 2}));
  BOOST_TEST(row["d"] == "more");
  const std::string print = format_table(table, TableFormat::latex),
                    screen = format_table(table, TableFormat::markdown);
  BOOST_TEST(screen.find("beta") != std::string::npos);
  BOOST_TEST(screen.find("gamma") != std::string::npos);
  BOOST_TEST(print.find("beta") == std::string::npos);
  BOOST_TEST(print.find("1.5") == std::string::npos);
  BOOST_TEST(print.find("gamma") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(terminals_have_texts_at_the_left_and_numbers_at_the_right) {
  const Table table{
      .columns = {{"a", "alpha", "{:g}"}, {"b", "beta"}, {"c", "gamma"}},
      .rows = {{.cells = {1.5, "long word", ""}}, {.cells = {-12.25, "x", ""}}}};
  BOOST_TEST(table_in_columns(table) ==
             " alpha  beta\n"
             "   1.5  long word\n"
             "-12.25  x\n");
}

BOOST_AUTO_TEST_SUITE_END()
