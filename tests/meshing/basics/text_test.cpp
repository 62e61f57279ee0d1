#include "meshing/basics/text.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(text_test)

// UTF-8 is what the Unicode Standard has (table 3-7): no longer forms, no halves of
// surrogates, nothing beyond U+10FFFF.
BOOST_AUTO_TEST_CASE(utf8_is_told_from_other_bytes) {
  for (const char* text :
       {"", "scene", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf"})
    BOOST_TEST(is_utf8(text), text);
  for (const char* bytes :
       {"\xff", "a\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
        "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xfc\x84\x80\x80\x80\x80"})
    BOOST_TEST(!is_utf8(bytes), quotation(bytes));
}

BOOST_AUTO_TEST_SUITE_END()
