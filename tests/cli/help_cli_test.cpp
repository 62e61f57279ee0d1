#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(help_cli_test)

BOOST_AUTO_TEST_CASE(without_a_command_it_tells_what_there_is) {
  const Run nothing = run_springcheck("", "COLUMNS=80 "), help = run_springcheck("help"),
            asked = run_springcheck("--help");
  BOOST_TEST(nothing.status == 2);  // nothing was done
  BOOST_TEST(help.status == 0);
  BOOST_TEST(asked.status == 0);
  BOOST_TEST(nothing.out == help.out);
  BOOST_TEST(asked.out == help.out);
  BOOST_TEST(help.out.find("springcheck run compression") != std::string::npos);
  BOOST_TEST(run_springcheck("help", "COLUMNS=50 ").out != help.out);
  for (const char* unusable : {"COLUMNS=0 ", "COLUMNS=1e9 ", "COLUMNS=-50 "})
    BOOST_TEST(run_springcheck("help", unusable).out == nothing.out, unusable);
}

BOOST_AUTO_TEST_CASE(help_version_and_lists_work) {
  for (const char* command :
       {"run", "table", "reproduce", "measure", "list", "mesh", "gate", "manual"}) {
    const std::string name(command);
    BOOST_TEST(run_springcheck(name + " --version").status == 0, name);
    const Run help = run_springcheck(name + " --help");
    BOOST_TEST(help.status == 0, name);
    BOOST_TEST(help.out.starts_with("Usage: springcheck " + name), name);
    BOOST_TEST(run_springcheck("help " + name).out == help.out, name);
  }
  BOOST_TEST(run_springcheck("--version").out.starts_with("springcheck "));
  const Json lists = json_of("list --json");
  for (const char* method : {"mss-baudet", "mss-nfd", "mss-fd", "mss-cf", "mss-custom",
                             "fem-hooke", "fem-stvk", "fem-hencky", "fem-cauchy-born"})
    BOOST_TEST(lists["methods"].contains(method), method);
  for (const char* scene : {"compression", "tension", "shearing", "torsion", "bending",
                            "bending-cm", "uniaxial", "traction", "affine"})
    BOOST_TEST(lists["scenes"].contains(scene), scene);
  BOOST_TEST(lists["scenes"]["bending-thesis-raw"]["description"] ==
             "The beam under its own weight as the thesis's performance study ran it: "
             "300,000 steps of 1 ms (Golec 2018, section 5.7)");
  for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"})
    BOOST_TEST(lists["elements"].contains(element), element);
  for (const char* law : {"hooke", "stvk", "hencky", "cauchy-born"})
    BOOST_TEST(lists["materials"].contains(law), law);
  BOOST_TEST(run_springcheck("list elements").out.find("q1-sri") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
