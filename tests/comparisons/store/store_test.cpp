#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/lock_file.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/sha256.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(store_test)

namespace {

/// Changes an HDF5 file, made if missing, in one commit.
template <class Change>
void change(const fs::path& file, Change&& change) {
  const bool is_new = !fs::exists(file);
  if (is_new) std::ofstream(file).flush();
  OverlayFile overlay(file);
  {
    const hdf5::Handle root(is_new ? overlay.create() : overlay.open(), H5Fclose, "test");
    change(root);
  }
  write_pages(file, overlay.writes());
}

void append(const fs::path& file, const std::vector<Row>& rows) {
  change(file, [&](hid_t root) {
    if (!hdf5::has_link(root, "table")) hdf5::create_group(root, "table");
    append_rows(hdf5::open_group(root, "table"), rows);
  });
}

Columns table_of(const fs::path& file) {
  return read_columns(hdf5::open_group(hdf5::open_file(file), "table"));
}

std::vector<double> numbers(std::initializer_list<double> values) {
  return values;
}

std::string bytes_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

PageWrites two_pages() {
  PageWrites writes;
  writes.file_size = 3 * page_size - 10;
  writes.pages[0].fill('a');
  writes.pages[2].fill('c');
  return writes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(columns_come_back_as_they_were_appended) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  append(file, {{{"key", "one"}, {"x", numbers({1})}, {"v", numbers({1, 2, 3})}}});
  append(file,
         {{{"key", "two"}, {"name", "\u03bd"}}, {{"key", "three"}, {"x", numbers({3})}}});
  const Columns table = table_of(file);
  BOOST_TEST(table.rows == 3U);
  BOOST_TEST((table.texts.at("key") == std::vector<std::string>{"one", "two", "three"}));
  BOOST_TEST((table.texts.at("name") == std::vector<std::string>{"", "\u03bd", ""}));
  const std::vector<double>& x = table.numbers.at("x").values;
  BOOST_TEST(x.size() == 3U);
  BOOST_TEST(x[0] == 1.);
  BOOST_TEST(std::isnan(x[1]));
  BOOST_TEST(x[2] == 3.);
  BOOST_TEST(table.numbers.at("v").width == 3U);
  BOOST_TEST(table.numbers.at("v").values[2] == 3.);
  BOOST_TEST(std::isnan(table.numbers.at("v").values[8]));
}

BOOST_AUTO_TEST_CASE(longer_texts_widen_their_column) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  const std::string shorter(32, 's'), longer(33, 'l'), longest(500, 'x');
  for (const std::string& text : {shorter, longer, longest, shorter})
    append(file, {{{"key", text}}});
  BOOST_TEST((table_of(file).texts.at("key") ==
              std::vector<std::string>{shorter, longer, longest, shorter}));
}

BOOST_AUTO_TEST_CASE(a_replaced_row_keeps_nothing_of_the_old_one) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  append(file, {{{"key", "one"}, {"x", numbers({1})}, {"name", "first"}},
                {{"key", "two"}, {"x", numbers({2})}}});
  change(file, [](hid_t root) {
    replace_row(hdf5::open_group(root, "table"), 0,
                {{"key", "new"}, {"y", numbers({7})}});
  });
  const Columns table = table_of(file);
  BOOST_TEST((table.texts.at("key") == std::vector<std::string>{"new", "two"}));
  BOOST_TEST(table.texts.at("name")[0].empty());
  BOOST_TEST(std::isnan(table.numbers.at("x").values[0]));
  BOOST_TEST(table.numbers.at("x").values[1] == 2.);
  BOOST_TEST(table.numbers.at("y").values[0] == 7.);
  BOOST_TEST(std::isnan(table.numbers.at("y").values[1]));
}

BOOST_AUTO_TEST_CASE(values_of_another_kind_or_width_are_refused_and_change_nothing) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  append(file, {{{"key", "one"}, {"x", numbers({1})}}});
  const std::string before = bytes_of(file);
  BOOST_CHECK_THROW(append(file, {{{"key", numbers({2})}}}), std::runtime_error);
  BOOST_CHECK_THROW(append(file, {{{"key", "two"}, {"x", numbers({1, 2})}}}),
                    std::runtime_error);
  BOOST_TEST(bytes_of(file) == before);
}

BOOST_AUTO_TEST_CASE(pages_are_written_and_their_journal_goes) {
  const OwnFolder own;
  const fs::path file = own.path / "a";
  std::ofstream(file) << std::string(2 * page_size, 'z');
  write_pages(file, two_pages());
  BOOST_TEST(bytes_of(file) == std::string(page_size, 'a') + std::string(page_size, 'z') +
                                   std::string(page_size - 10, 'c'));
  BOOST_TEST(!fs::exists(journal_of(file)));
}

// A program killed while it writes the file has left its journal whole: any part of the
// file may be old. Killed before, the journal is cut: nothing of the file is new.
BOOST_AUTO_TEST_CASE(a_whole_journal_is_applied_and_a_cut_one_is_not) {
  const OwnFolder own;
  const fs::path file = own.path / "a";
  std::ofstream(file) << std::string(2 * page_size, 'z');
  // The journal of two_pages, written by hand from its description.
  std::string journal;
  const auto number = [&](std::uint64_t n) {
    for (int i = 0; i < 8; ++i) journal += static_cast<char>((n >> (8 * i)) & 0xffU);
  };
  journal = "springcheck journal 1\n" + std::string(10, '\0');
  number(3 * page_size - 10);
  number(2);
  number(0);
  journal += sha256(std::string(page_size, 'z')) + std::string(page_size, 'a');
  number(2);
  journal += sha256(std::string(page_size, '\0')) + std::string(page_size, 'c');
  journal += sha256(journal);
  for (const std::size_t cut : {journal.size() - 1, journal.size() / 2, 40UL, 0UL}) {
    std::ofstream(journal_of(file), std::ios::binary) << journal.substr(0, cut);
    recover(file);
    BOOST_TEST(bytes_of(file) == std::string(2 * page_size, 'z'));
    BOOST_TEST(!fs::exists(journal_of(file)));
  }
  std::string damaged = journal;
  damaged[100] = 'x';
  std::ofstream(journal_of(file), std::ios::binary) << damaged;
  recover(file);
  BOOST_TEST(bytes_of(file) == std::string(2 * page_size, 'z'));
  std::ofstream(journal_of(file), std::ios::binary) << journal;
  recover(file);
  BOOST_TEST(bytes_of(file) == std::string(page_size, 'a') + std::string(page_size, 'z') +
                                   std::string(page_size - 10, 'c'));
  BOOST_TEST(!fs::exists(journal_of(file)));
}

// A journal that another file has left under this name, say before a backup came back.
BOOST_AUTO_TEST_CASE(a_journal_of_other_content_is_refused_and_kept) {
  const OwnFolder own;
  const fs::path file = own.path / "a";
  std::ofstream(file) << std::string(2 * page_size, 'z');
  std::string journal = "springcheck journal 1\n" + std::string(10, '\0');
  const auto number = [&](std::uint64_t n) {
    for (int i = 0; i < 8; ++i) journal += static_cast<char>((n >> (8 * i)) & 0xffU);
  };
  number(2 * page_size);
  number(1);
  number(1);
  journal += sha256(std::string(page_size, 'y')) + std::string(page_size, 'b');
  journal += sha256(journal);
  std::ofstream(journal_of(file), std::ios::binary) << journal;
  BOOST_CHECK_EXCEPTION(recover(file), InputError, [](const InputError& e) {
    return std::string(e.what()).find("one of other content") != std::string::npos;
  });
  BOOST_TEST(bytes_of(file) == std::string(2 * page_size, 'z'));
  BOOST_TEST(bytes_of(journal_of(file)) == journal);
  // Half applied already: the page is as it is to be.
  std::ofstream(file) << std::string(page_size, 'z') << std::string(page_size, 'b');
  recover(file);
  BOOST_TEST(!fs::exists(journal_of(file)));
}

BOOST_AUTO_TEST_CASE(a_second_writer_is_refused_with_the_first_one_s_process_id) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  {
    const LockFile first(file);
    BOOST_CHECK_EXCEPTION(LockFile second(file), InputError, [](const InputError& e) {
      return std::string(e.what()).ends_with("got one that process " +
                                             std::to_string(getpid()) + " is writing");
    });
  }
  BOOST_TEST(!fs::exists(file.string() + ".lock"));
  BOOST_CHECK_NO_THROW(LockFile third(file));
  std::ofstream(file.string() + ".lock") << "999999\n";  // of one that was killed
  BOOST_CHECK_NO_THROW(LockFile fourth(file));
}

namespace {

/// Commits cases 0, 1, ... and says so after each, until it is killed.
[[noreturn]] void write_until_killed(const fs::path& file, int said) {
  const LockFile lock(file);
  recover(file);
  auto next = static_cast<int>(
      fs::exists(file) && fs::file_size(file) > 0 ? table_of(file).rows : 0);
  for (;; ++next) {
    change(file, [&](hid_t root) {
      if (!hdf5::has_link(root, "table")) {
        hdf5::create_group(root, "table");
        hdf5::create_group(root, "fields");
      }
      const double x = next;
      append_rows(hdf5::open_group(root, "table"),
                  {{{{"key", "case " + std::to_string(next)},
                     {"x", numbers({x})},
                     {"v", numbers({x, x, x})}}}});
      hdf5::write_table(hdf5::open_group(root, "fields"), "case " + std::to_string(next),
                        std::vector<double>(3000, x), 3);
    });
    if (write(said, &next, sizeof next) != sizeof next) _exit(1);
  }
}

}  // namespace

// kill -9, sixty times, after random times between none and some twenty commits; more
// often and later where a slow machine lets few commits through, so that there are some
// to lose.
BOOST_AUTO_TEST_CASE(nothing_that_was_committed_is_lost_and_nothing_is_half_true) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  change(file, [](hid_t root) {
    hdf5::create_group(root, "table");
    hdf5::create_group(root, "fields");
  });
  std::mt19937 random(1);
  std::uniform_int_distribution<int> microseconds(0, 30000);  // times 1 + round / 60
  int committed = -1, journals = 0;
  for (int round = 0; round < 60 || (committed <= 60 && round < 600); ++round) {
    std::array<int, 2> pipe_ends{};
    BOOST_TEST_REQUIRE(pipe(pipe_ends.data()) == 0);
    const pid_t child = fork();
    if (child == 0) write_until_killed(file, pipe_ends[1]);
    close(pipe_ends[1]);
    std::this_thread::sleep_for(
        std::chrono::microseconds(microseconds(random) * (1 + round / 60)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (int said = 0; read(pipe_ends[0], &said, sizeof said) == sizeof said;)
      committed = said;
    close(pipe_ends[0]);

    journals += fs::exists(journal_of(file)) ? 1 : 0;
    recover(file);
    const Columns table = table_of(file);
    BOOST_TEST(static_cast<int>(table.rows) >= committed + 1);
    BOOST_TEST(static_cast<int>(table.rows) <= committed + 2);  // done, not yet said
    const auto fields = hdf5::open_group(hdf5::open_file(file), "fields");
    const auto whole = [&](int row) {
      const auto r = static_cast<std::size_t>(row);
      const std::string key = "case " + std::to_string(row);
      const auto field = hdf5::read_table(fields, key);
      return table.texts.at("key")[r] == key && table.numbers.at("x").values[r] == row &&
             table.numbers.at("v").values[3 * r + 2] == row && field &&
             *field == std::vector<double>(3000, row);
    };
    for (int row = 0; row < static_cast<int>(table.rows); ++row)
      BOOST_TEST(whole(row), "row " << row << " in round " << round);
    committed = std::max(committed, static_cast<int>(table.rows) - 1);
  }
  BOOST_TEST(committed > 60);
  BOOST_TEST_MESSAGE(committed << " commits, " << journals << " journals left");
}

// Another program's, or made to harm: HDF5 would write a pointer for each text behind
// that of one.
BOOST_AUTO_TEST_CASE(an_attribute_of_several_texts_is_refused) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  const hdf5::Handle root(
      H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "a");
  const hdf5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "type");
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  for (const hsize_t count : {0U, 2U, 1000U}) {
    const std::string name = "of" + std::to_string(count);
    const hdf5::Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "space");
    const hdf5::Handle attribute(
        H5Acreate2(root, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
        "attribute");
    const std::vector<const char*> texts(count, "text");
    H5Awrite(attribute, type, texts.data());
    BOOST_CHECK_THROW(hdf5::read_text(root, name), std::runtime_error);
  }
}

// Nothing of it was ever written: 8 TB of fill values in a file of some kilobytes.
BOOST_AUTO_TEST_CASE(a_table_that_claims_more_than_its_file_can_hold_is_refused) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  append(file, {{{"x", numbers({1})}, {"key", "one"}}});
  {
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                            "a");
    const hsize_t size = hsize_t{1} << 40;
    for (const char* column : {"table/x", "table/key"}) {
      const hdf5::Handle table(H5Dopen2(root, column, H5P_DEFAULT), H5Dclose, column);
      BOOST_TEST_REQUIRE(H5Dset_extent(table, &size) >= 0);
    }
  }
  const auto is_claim = [](const std::runtime_error& error) {
    return std::string(error.what()).find("claims") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(table_of(file), std::runtime_error, is_claim);
  const auto root = hdf5::open_file(file);
  BOOST_CHECK_EXCEPTION(read_texts(hdf5::open_group(root, "table"), "key"),
                        std::runtime_error, is_claim);
  BOOST_CHECK_EXCEPTION(hdf5::read_table(hdf5::open_group(root, "table"), "x"),
                        std::runtime_error, is_claim);
}

BOOST_AUTO_TEST_SUITE_END()
