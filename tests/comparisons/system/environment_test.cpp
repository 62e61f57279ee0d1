#include "comparisons/system/environment.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "comparisons/system/processor.hpp"
#include "comparisons/system/temporary_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(environment_test)

BOOST_AUTO_TEST_CASE(what_a_process_computes_with_is_told) {
  const Environment here = environment();
  for (const std::string& told :
       {here.processor, here.clock, here.instructions, here.compiler, here.flags})
    BOOST_TEST(!told.empty());
  BOOST_TEST(here.blas.starts_with("OpenBLAS 0."), here.blas);
  BOOST_TEST(here.flags.find("-O") != std::string::npos, here.flags);
  BOOST_TEST(here.cores >= 1);
  const std::string text = text_of(here);
  for (const std::string& told :
       {here.processor, here.machine, here.clock, here.instructions, here.blas,
        here.compiler, here.flags})
    BOOST_TEST(text.find(told) != std::string::npos, told);
}

BOOST_AUTO_TEST_CASE(threads_are_limited_while_they_are_in_use) {
  const int before = environment().threads;
  {
    const ThreadsInUse one(1);
    BOOST_TEST(environment().threads == 1);
  }
  BOOST_TEST(environment().threads == before);
}

BOOST_AUTO_TEST_CASE(who_sets_the_clock_is_read_as_linux_tells_it) {
  const TemporaryFolder folder("clock");
  const fs::path cpu = folder.path() / "sys/devices/system/cpu";
  const auto write = [&](const char* file, const char* text) {
    fs::create_directories((cpu / file).parent_path());
    std::ofstream(cpu / file) << text << "\n";
  };
  BOOST_TEST(clock_policy(folder.path()) == "unknown");
  write("cpu0/cpufreq/scaling_governor", "performance");
  BOOST_TEST(clock_policy(folder.path()) == "governor performance");
  write("intel_pstate/no_turbo", "1");
  BOOST_TEST(clock_policy(folder.path()) == "governor performance, boost off");
  write("intel_pstate/no_turbo", "0");
  BOOST_TEST(clock_policy(folder.path()) == "governor performance, boost on");
  fs::remove_all(cpu / "intel_pstate");
  write("cpufreq/boost", "0");
  BOOST_TEST(clock_policy(folder.path()) == "governor performance, boost off");
}

BOOST_AUTO_TEST_SUITE_END()
