#include "comparisons/cases/model.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(model_test)

namespace {

constexpr auto single = dynamics::Precision::single_precision;

}  // namespace

BOOST_AUTO_TEST_CASE(names_say_all_that_is_not_usual) {
  BOOST_TEST(name_of(Model{.method = "mss-cf"}) == "mss-cf");
  BOOST_TEST(name_of(Model{
                 .method = "fem-stvk", .element = "q1-sri", .linear_solver = "direct"}) ==
             "fem-stvk:q1-sri, direct");
  BOOST_TEST(name_of(Model{.method = "mss-affine",
                           .cells = CellType::tetrahedron,
                           .precision = single}) == "mss-affine on tetrahedra, float");
}

// Files of before 0.3.0 keep the name alone.
BOOST_AUTO_TEST_CASE(a_name_gives_the_model_back) {
  for (const char* element : {"", "q1", "q2"})
    for (const CellType cells : all_cell_types)
      for (const char* linear_solver : {"", "direct", "multigrid"}) {
        const Model model{.method = "fem-stvk",
                          .element = element,
                          .cells = cells,
                          .linear_solver = linear_solver};
        BOOST_TEST((model_in(name_of(model)) == model), name_of(model));
      }
  const Model motion{
      .method = "mss-affine", .cells = CellType::prism, .precision = single};
  BOOST_TEST((model_in(name_of(motion)) == motion));
  BOOST_TEST((model_in("") == Model{}));
}

BOOST_AUTO_TEST_SUITE_END()
