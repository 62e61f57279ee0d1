#include "comparisons/formats/wrapped_text.hpp"

#include <boost/test/unit_test.hpp>

using springcheck::wrapped;

BOOST_AUTO_TEST_SUITE(wrapped_text_test)

BOOST_AUTO_TEST_CASE(lines_end_between_words) {
  BOOST_TEST(wrapped("one two three", 7) == "one two\nthree");
  BOOST_TEST(wrapped("one two three", 13) == "one two three");
  BOOST_TEST(wrapped("one two", 6, 2) == "one\n  two");
  BOOST_TEST(wrapped("one two", 8, 2, 4) == "one\n  two");
  BOOST_TEST(wrapped("one  two ", 80) == "one two");
  BOOST_TEST(wrapped("", 80).empty());
}

BOOST_AUTO_TEST_CASE(a_word_that_is_too_long_has_a_line_of_its_own) {
  BOOST_TEST(wrapped("a METHOD[:ELEMENT] b", 6, 1) == "a\n METHOD[:ELEMENT]\n b");
}

BOOST_AUTO_TEST_CASE(characters_count_not_bytes) {
  BOOST_TEST(wrapped("κ₀ μν", 5) == "κ₀ μν");
}

BOOST_AUTO_TEST_CASE(an_entry_stands_below_its_name_where_a_word_is_too_long) {
  BOOST_TEST(wrapped_entry("name", "short text", 10, 20) == "  name    short text\n");
  BOOST_TEST(wrapped_entry("a longer name", "text", 10, 20) ==
             "  a longer name\n          text\n");
  BOOST_TEST(wrapped_entry("name", "METHOD@CELLS or so", 10, 18) ==
             "  name\n      METHOD@CELLS\n      or so\n");
}

BOOST_AUTO_TEST_SUITE_END()
