#include "comparisons/formats/text_table.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(text_table_test)

namespace {

const TextLines lines{{"method", "status", "force N"},
                      {"mss-cf", "ok", "1.5"},
                      {"fem-stvk", "diverged", ""},
                      {"mss-nfd", "ok", "12.25"}};

}  // namespace

BOOST_AUTO_TEST_CASE(what_fits_stands_in_columns) {
  const std::string text =
      "method      status  force N\n"
      "mss-cf          ok      1.5\n"
      "fem-stvk  diverged\n"
      "mss-nfd         ok    12.25\n";
  BOOST_TEST(in_columns(lines) == text);
  BOOST_TEST(in_columns(lines, {}, {.width = 27}) == text);
  BOOST_TEST(in_columns(lines, {Align::left, Align::left, Align::right}) ==
             "method    status    force N\n"
             "mss-cf    ok            1.5\n"
             "fem-stvk  diverged\n"
             "mss-nfd   ok          12.25\n");
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_turned) {
  BOOST_TEST(in_columns(lines, {}, {.width = 26}) ==
             "method   mss-cf  fem-stvk\n"
             "status   ok      diverged\n"
             "force N  1.5\n"
             "\n"
             "method   mss-nfd\n"
             "status   ok\n"
             "force N  12.25\n");
  // One line at least, however wide it is.
  BOOST_TEST(in_columns({{"gate"}, {"one"}, {"other"}}, {}, {.width = 1}) ==
             "gate  one\n\ngate  other\n");
  BOOST_TEST(in_columns({{"method", "status"}}, {}, {.width = 5}) == "method  status\n");
}

BOOST_AUTO_TEST_CASE(letters_of_several_bytes_are_one_character) {
  BOOST_TEST(in_columns({{"gate", "got"}, {"Größe", "1"}, {"ascii", "10"}}) ==
             "gate   got\nGröße    1\nascii   10\n");
}

BOOST_AUTO_TEST_CASE(a_line_that_is_too_wide_alone_has_line_ends) {
  BOOST_TEST(in_columns({{"name", "title"}, {"a", "what it is of"}}, {}, {.width = 14}) ==
             "name   a\n"
             "title  what it\n"
             "       is of\n");
}

BOOST_AUTO_TEST_CASE(colours_need_no_room) {
  const auto colour_of = [](std::string_view head, std::string_view cell) {
    return head != "status" ? Colour::usual : cell == "ok" ? Colour::good : Colour::bad;
  };
  const std::string green = "\x1b[32m", red = "\x1b[31m", end = "\x1b[0m";
  BOOST_TEST(in_columns(lines, {Align::left, Align::left},
                        {.width = 27, .colour_of = colour_of}) ==
             "method    status    force N\n"
             "mss-cf    " +
                 green + "ok" + end + "            1.5\n" + "fem-stvk  " + red +
                 "diverged" + end + "\n" + "mss-nfd   " + green + "ok" + end +
                 "          12.25\n");
  BOOST_TEST(in_columns(lines, {}, {.width = 15, .colour_of = colour_of})
                 .starts_with("method   mss-cf\nstatus   " + green + "ok" + end + "\n"));
}

BOOST_AUTO_TEST_SUITE_END()
