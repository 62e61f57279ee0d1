#include <boost/test/unit_test.hpp>
#include <fstream>

#include "comparisons/store/stored_columns.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(large_store_test)

namespace {

/// A row like a case's: fifty numbers and ten texts.
Row row_of(std::size_t index) {
  Row row;
  row["key"] = std::to_string(index);
  for (int i = 0; i < 50; ++i)
    row["number " + std::to_string(i)] =
        std::vector<double>(1, static_cast<double>(index));
  for (int i = 0; i < 10; ++i) row["text " + std::to_string(i)] = std::string("text");
  return row;
}

/// Appends rows and returns how many pages of the file that changes.
std::size_t append(const fs::path& file, std::size_t first, std::size_t count) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < count; ++i) rows.push_back(row_of(first + i));
  OverlayFile overlay(file);
  {
    const hdf5::Handle root(first == 0 ? overlay.create() : overlay.open(), H5Fclose,
                            file.string());
    append_rows(root, rows);
  }
  write_pages(file, overlay.writes());
  return overlay.writes().pages.size();
}

}  // namespace

// What an append writes is what it costs: pages, counted and not timed. Between 1000 and
// 100,000 rows only the trees of chunks grow, by one level, which is a page for each of
// the 61 columns.
BOOST_AUTO_TEST_CASE(appending_to_many_cases_writes_as_much_as_appending_to_few) {
  const OwnFolder own;
  const fs::path file = own.path / "many.h5";
  std::ofstream(file).flush();
  append(file, 0, 1000);
  const std::size_t few = append(file, 1000, 1);
  for (std::size_t rows = 1001; rows < 100'000; rows += 5000) append(file, rows, 5000);
  const std::size_t rows = row_count(hdf5::open_file(file));
  BOOST_TEST(rows > 100'000U);
  const std::size_t many = append(file, rows, 1);
  BOOST_TEST_MESSAGE(few << " and " << many << " pages");
  BOOST_TEST(many <= few + 61);
}

BOOST_AUTO_TEST_SUITE_END()
