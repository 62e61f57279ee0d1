#include "comparisons/formats/parquet.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(parquet_test)

namespace {

std::string bytes_of(const std::vector<ParquetColumn>& columns) {
  std::ostringstream out;
  write_parquet(out, columns);
  return out.str();
}

/// The bytes that hexadecimal digits with blanks between them give.
std::string bytes(std::string_view digits) {
  std::istringstream in{std::string(digits)};
  std::string all, two;
  while (in >> two) all += static_cast<char>(std::stoi(two, nullptr, 16));
  return all;
}

}  // namespace

// These very bytes are read, with both nulls, by hyparquet 1.33 and by arrow-rs
// (parquet-wasm 0.8): independent readers.
BOOST_AUTO_TEST_CASE(a_table_is_bytes_that_others_read) {
  const std::string text_page =  // head; runs of what is there; values
      "15 00 15 3c 15 3c 2c 15 08 15 00 15 06 15 06 00 00 "
      "06 00 00 00 02 01 02 00 04 01 "
      "03 00 00 00 6f 6e 65 04 00 00 00 64 72 65 69 01 00 00 00 34 ";
  const std::string number_page =
      "15 00 15 34 15 34 2c 15 08 15 00 15 06 15 06 00 00 "
      "06 00 00 00 02 01 04 00 02 01 "
      "00 00 00 00 00 00 f8 3f 00 00 00 00 00 00 00 c0 ";
  const std::string schema =
      "15 02 19 3c 48 05 63 61 73 65 73 15 04 00 "
      "15 0c 25 02 18 04 6e 61 6d 65 25 00 4c 1c 00 00 00 "
      "15 0a 25 02 18 09 66 6f 72 63 65 20 5b 4e 5d 00 ";
  const std::string rows =
      "16 08 19 1c 19 2c "
      "26 08 1c 15 0c 19 25 00 06 19 18 04 6e 61 6d 65 15 00 16 08 16 5e 16 5e 26 08 00 "
      "00 "
      "26 66 1c 15 0a 19 25 00 06 19 18 09 66 6f 72 63 65 20 5b 4e 5d 15 00 16 08 16 56 "
      "16 56 26 66 00 00 "
      "16 b4 01 16 08 00 ";
  const std::string end = "28 0b 73 70 72 69 6e 67 63 68 65 63 6b 00 86 00 00 00 ";
  BOOST_TEST(bytes_of({{"name", std::vector<std::string>{"one", "", "drei", "4"}},
                       {"force [N]",
                        std::vector<double>{1.5, std::nan(""), std::nan(""), -2}}}) ==
             "PAR1" + bytes(text_page + number_page + schema + rows + end) + "PAR1");
}

// More than fourteen columns and a long run need numbers of several bytes.
BOOST_AUTO_TEST_CASE(lists_and_runs_may_be_long) {
  std::vector<ParquetColumn> columns(20, {"x", std::vector<double>(1000, 1.)});
  const std::string all = bytes_of(columns);
  BOOST_TEST(all.find(bytes("19 fc 15 48 05 63 61 73 65 73 15 28 00")) !=
             std::string::npos);  // 21 elements of the schema, of which 20 are columns
  BOOST_TEST(all.find(bytes("03 00 00 00 d0 0f 01")) !=
             std::string::npos);  // 1000 values
}

BOOST_AUTO_TEST_CASE(a_table_may_have_no_rows) {
  const std::string all = bytes_of({{"a", std::vector<double>{}}});
  BOOST_TEST(all.starts_with("PAR1"));
  BOOST_TEST(all.find(bytes("16 00 19 0c 28 0b")) != std::string::npos);  // no row group
}

BOOST_AUTO_TEST_SUITE_END()
