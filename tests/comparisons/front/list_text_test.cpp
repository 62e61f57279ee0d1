#include "comparisons/front/list_text.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(list_text_test)

namespace {

using Json = nlohmann::ordered_json;

const Json lists{{"methods",
                  {{"mss-cf",
                    {{"description", "springs of constant form"},
                     {"covers", "any nu"},
                     {"look", {{"colour", "red"}}},
                     {"solvers", {"direct", "verlet"}},
                     {"elastic", true}}}}},
                 {"measures",
                  {{"force",
                    {{"description", "of the plate"},
                     {"unit", "N"},
                     {"components", 3},
                     {"tests", {"tension"}}}},
                   {"volume",
                    {{"description", "of the body"},
                     {"unit", ""},
                     {"tests", {"tension", "torsion"}}}}}},
                 {"scenes", {{"block", "a block, pressed"}}}};

}  // namespace

BOOST_AUTO_TEST_CASE(a_line_for_each_entry_where_there_is_room) {
  BOOST_TEST(list_text(lists, std::nullopt) ==
             "methods\n"
             "  mss-cf          springs of constant form\n"
             "                  covers any nu\n"
             "measures\n"
             "  force [N]       of the plate\n"
             "                  in tension\n"
             "  volume          of the body\n"
             "scenes\n"
             "  block           a block, pressed\n");
}

BOOST_AUTO_TEST_CASE(lines_end_where_the_terminal_does) {
  BOOST_TEST(list_text({{"methods", lists["methods"]}}, 27) ==
             "methods\n"
             "  mss-cf\n"
             "         springs of\n"
             "         constant form\n"
             "         covers any nu\n");
}

BOOST_AUTO_TEST_CASE(a_table_has_every_key_but_objects) {
  BOOST_TEST(lists_as_table(lists, TableFormat::csv) ==
             "list,name,description,covers,solvers,elastic,unit,components,tests\n"
             "methods,mss-cf,springs of constant form,any nu,direct verlet,yes,,,\n"
             "measures,force,of the plate,,,,N,3,tension\n"
             "measures,volume,of the body,,,,,,tension torsion\n"
             "scenes,block,\"a block, pressed\",,,,,,\n");
  const Json scenes{{"scenes", lists["scenes"]}};
  BOOST_TEST(lists_as_table(scenes, TableFormat::markdown)
                 .find("| scenes | block | a block, pressed |") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
