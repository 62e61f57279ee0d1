#include "comparisons/formats/latex_table.hpp"

#include <boost/test/unit_test.hpp>

#include "comparisons/formats/latex_escape.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(latex_table_test)

namespace {

void expect_part(const std::string& text, const std::string& part) {
  BOOST_TEST(text.find(part) != std::string::npos, part << " is not in\n" << text);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_latex_would_act_on_is_escaped) {
  BOOST_TEST(latex_escaped("{a_b} & 5 % # $x") == "\\{a\\_b\\} \\& 5 \\% \\# \\$x");
  BOOST_TEST(latex_escaped("\\x^2~") ==
             "\\textbackslash{}x\\textasciicircum{}2\\textasciitilde{}");
  BOOST_TEST(latex_escaped("a < b > c") == "a \\textless{} b \\textgreater{} c");
  BOOST_TEST(latex_escaped("bar (+-)") == "bar ($\\pm$)");
  BOOST_TEST(latex_escaped("a\tb") == "aU+0009b");
}

BOOST_AUTO_TEST_CASE(quotes_and_code_are_set_as_in_print) {
  BOOST_TEST(latex_escaped("the \"law\" (\"Hooke\")") == "the ``law'' (``Hooke'')");
  BOOST_TEST(latex_escaped("`--jobs 2` `it") ==
             "\\texttt{-{}-jobs 2} \\textasciigrave{}it");
}

// Latin letters go through inputenc; pdfLaTeX has no glyphs of the others.
BOOST_AUTO_TEST_CASE(letters_that_pdflatex_lacks_are_named) {
  BOOST_TEST(latex_escaped("Lamé, Łódź") == "Lamé, Łódź");
  BOOST_TEST(latex_escaped("ν 中 𝜈") == "U+03BD U+4E2D U+1D708");
  BOOST_TEST(latex_escaped("a\xFF\xC3") == "aU+FFFDU+FFFD");
}

BOOST_AUTO_TEST_CASE(a_table_is_one_float) {
  const std::string text = latex_text(
      {{"nu", "method", "ours e [%]", "notes"},
       {"0.25", "mss-cf", "-1.5", "1 2"},
       {"0.4", "[a]", "diverged", ""},
       {"0.49", "fem_x", "3.25", "2"}},
      {.title = "Error & bar", .notes = {"On all."}, .footnotes = {"First.", "Second."}});
  BOOST_TEST(
      text.starts_with("% needs \\usepackage{booktabs,adjustbox}\n\\begin{table}"));
  BOOST_TEST(text.ends_with("\\end{table}\n"));
  expect_part(text, "\\caption{Error \\& bar}");
  expect_part(text,
              "{@{}rlrl@{}}\n  \\toprule\n  nu & method & ours e [\\%] & notes \\\\");
  expect_part(text,
              "  \\midrule\n  0.25 & mss-cf & $-$1.5 & \\textsuperscript{1 2} \\\\\n");
  expect_part(text, "  0.4 & [a] & diverged &  \\\\\n");
  expect_part(text, "fem\\_x");
  expect_part(text,
              "On all.\n\\par\\smallskip \\textsuperscript{1} First.\n"
              "\\par\\smallskip \\textsuperscript{2} Second.\n\\end{minipage}");
}

// Else a wide head makes a wide column; and a line of a bracket is no length for LaTeX.
BOOST_AUTO_TEST_CASE(long_heads_are_broken_between_words) {
  const std::string text =
      latex_text({{"largest V/V0 of a cell [-]", "on"}, {"1", "[b]"}, {"2", ""}},
                 {.title = "t", .notes = {}, .footnotes = {}});
  expect_part(text, "\\shortstack[r]{largest V/V0\\\\of a cell\\\\{}[-]} & on \\\\");
  BOOST_TEST(latex_text({{"a"}, {"[b]"}}, {.title = "", .notes = {}, .footnotes = {}})
                 .find("\\midrule\n  {}[b] \\\\") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(long_tables_are_several_floats_with_notes_below_the_last) {
  TextLines lines{{"n"}};
  for (int n = 1; n <= 81; ++n) lines.push_back({std::to_string(n)});
  const std::string text =
      latex_text(lines, {.title = "Long", .notes = {"Below."}, .footnotes = {}});
  BOOST_TEST(count(text, "\\begin{table}") == 3U);
  BOOST_TEST(count(text, "\\caption") == 1U);
  BOOST_TEST(count(text, "\\thetable, continued") == 2U);
  BOOST_TEST(count(text, " \\\\\n") == 81U + 3U);
  BOOST_TEST(count(text, "Below.") == 1U);
  BOOST_TEST(text.find("Below.") > text.find("  81 \\\\"));
}

// Sideways from 120 characters on; texts that are long are broken.
BOOST_AUTO_TEST_CASE(wide_tables_are_turned) {
  const auto table_of = [](std::size_t columns) {
    TextLines lines{{}, {}};
    for (std::size_t i = 0; i < columns; ++i) {
      lines[0].push_back("reason");
      lines[1].push_back(std::string(100, 'w'));
    }
    return latex_text(lines, {.title = "Wide", .notes = {}, .footnotes = {}});
  };
  const std::string upright = table_of(3), sideways = table_of(4);
  BOOST_TEST(upright.starts_with("% needs \\usepackage{booktabs,adjustbox}\n"));
  expect_part(upright, "\\begin{table}");
  expect_part(upright, "{@{}p{14em}p{14em}p{14em}@{}}");
  BOOST_TEST(sideways.starts_with("% needs \\usepackage{booktabs,adjustbox,rotating}\n"));
  expect_part(sideways, "\\begin{sidewaystable}");
  BOOST_TEST(sideways.ends_with("\\end{sidewaystable}\n\\endgroup\n"));
  // The page's width, taken before the float, which is turned.
  BOOST_TEST(sideways.find("\\the\\dimexpr.85\\textwidth") <
             sideways.find("\\begin{sidewaystable}"));
  expect_part(sideways, "{max totalheight=\\pagewidth}");
}

BOOST_AUTO_TEST_CASE(what_every_row_says_is_said_once) {
  const std::string text = latex_text({{"mesh", "nu", "e [%]", "case"},
                                       {"4x4x4", "0.1", "1", "ab"},
                                       {"4x4x4", "0.2", "2", "cd"},
                                       {"4x4x4", "0.3", "2", "ef"}},
                                      {.title = "t", .notes = {"Own."}, .footnotes = {}});
  expect_part(text, "{@{}rr@{}}\n  \\toprule\n  nu & e [\\%] \\\\\n");
  expect_part(text, "  0.2 & 2 \\\\ % case cd\n");
  expect_part(text, "In all rows: mesh 4x4x4.\n\\par\\smallskip Own.");
}

BOOST_AUTO_TEST_SUITE_END()
