#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <iterator>

BOOST_AUTO_TEST_SUITE(machine_limits_cli_test)

// OpenBLAS would ask for its buffer for ever. Whatever the limit, the run ends.
BOOST_AUTO_TEST_CASE(little_address_space_ends_a_run_clearly) {
  for (const int megabytes : {600, 700, 800, 900, 1000}) {
    const Run run =
        run_springcheck("run compression --cells 14,14,14 --method mss-cf --threads 1",
                        "ulimit -v " + std::to_string(megabytes) + "000; timeout 60 ");
    BOOST_TEST((run.status == 0 || run.status == 1 || run.status == 2),
               megabytes << " MB: " << run.status << run.err);
    if (run.status == 1)
      BOOST_TEST(run.err.find("memory is not enough") != std::string::npos, run.err);
    if (run.status == 2) {
      const bool is_told =
          run.err.find("address space (ulimit -v)") != std::string::npos ||
          run.err.find("may still take") != std::string::npos;
      BOOST_TEST(is_told, run.err);
    }
  }
}

// OpenBLAS's thread, which it starts before the program and which asks for a buffer as
// well, does not keep a program from its end either.
BOOST_AUTO_TEST_CASE(little_address_space_ends_every_command) {
  for (const int megabytes : {520, 560, 600, 620, 700})
    for (const char* command :
         {"--version", "list columns", "run compression --cells 2,2,2 --method mss-cf"}) {
      const Run run = run_springcheck(
          command, "ulimit -v " + std::to_string(megabytes) +
                       "000; timeout 60 env --unset=OPENBLAS_NUM_THREADS ");
      BOOST_TEST((run.status == 0 || run.status == 2),
                 megabytes << " MB: " << command << ": " << run.status << run.err);
    }
}

// There are more threads than OpenBLAS has places for; it wrote behind the last place.
BOOST_AUTO_TEST_CASE(many_threads_run_in_a_limited_address_space) {
  const Run run =
      run_springcheck("run compression --cells 2,2,2 --method mss-cf --threads 512",
                      "ulimit -v 80000000; timeout 60 ");
  BOOST_TEST(run.status == 0, run.status << run.err);
}

// The disk holds 8 blocks of 512 bytes: less than any result or mesh of this size.
BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_old_file_alone) {
  for (const char* command :
       {"run compression --method mss-cf --cells 4,4,4 --out", "mesh tension --out"}) {
    const bool is_run = std::string(command).starts_with("run");
    const std::string file = is_run ? "kept.h5" : "kept.msh";
    const std::string arguments = std::string(command) + " " + file;
    BOOST_TEST(run_springcheck(arguments).status == 0);
    const std::string before = text_of(folder / file);
    const auto files = [] {
      return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    };
    const auto files_before = files();
    const Run run = run_springcheck(arguments, "ulimit -f 8; ");
    BOOST_TEST(run.status == 1, run.err);
    const char* expected = is_run ? "File too large" : "could not be written whole";
    BOOST_TEST(run.err.find(expected) != std::string::npos, run.err);
    BOOST_TEST((text_of(folder / file) == before));
    BOOST_TEST(files() == files_before);  // nothing is left lying about
  }
}

BOOST_AUTO_TEST_CASE(lost_output_is_a_failure) {
  const Run run = run_springcheck("list >/dev/full");
  BOOST_TEST(run.status == 1);
}

BOOST_AUTO_TEST_CASE(a_link_stays_a_link) {
  fs::create_symlink("behind.inp", folder / "link.inp");
  BOOST_TEST(run_springcheck("mesh tension --out link.inp").status == 0);
  BOOST_TEST(fs::is_symlink(folder / "link.inp"));
  BOOST_TEST(fs::file_size(folder / "behind.inp") > 0U);
}

BOOST_AUTO_TEST_SUITE_END()
