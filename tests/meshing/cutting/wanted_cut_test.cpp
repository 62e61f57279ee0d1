#include "meshing/cutting/wanted_cut.hpp"

#include <boost/test/unit_test.hpp>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(wanted_cut_test)

namespace {

Mesh cube(CellPattern pattern) {
  return generate_block(
      {.size = {0.05, 0.05, 0.05}, .cells = {10, 10, 10}, .pattern = pattern});
}

WantedCut slit(double z) {
  return {.name = "slit",
          .kind = CutKind::split,
          .where = {.surface = Plane{.normal = {0, 0, 1}, .offset = z},
                    .within = Box{.low = {0, 0, 0}, .high = {0.025, 0.05, 0.05}}},
          .place = "here"};
}

}  // namespace

BOOST_AUTO_TEST_CASE(figures_tell_what_became_of_the_body) {
  const MadeCut split = make_cut(cube(CellPattern::hexahedron), slit(0.025));
  BOOST_TEST(split.figures.faces_split == 50);
  BOOST_TEST(split.figures.nodes_added == 55);
  BOOST_TEST(split.figures.cells_removed == 0);
  BOOST_TEST(split.figures.area == 0.05 * 0.025, tolerance(1e-13));
  BOOST_TEST(split.figures.volume_removed == 0);
  BOOST_TEST(split.figures.farthest < 1e-16);
  // A millimetre above the layers' common faces, which are taken all the same.
  BOOST_TEST(
      make_cut(cube(CellPattern::hexahedron), slit(0.026)).figures.farthest == 0.001,
      tolerance(1e-12));

  const MadeCut hollow =
      make_cut(cube(CellPattern::hexahedron),
               {.name = "cavity",
                .kind = CutKind::remove,
                .where = {.surface = Box{.low = {0.015, 0.015, 0.015},
                                         .high = {0.035, 0.035, 0.035}}}});
  BOOST_TEST(hollow.figures.cells_removed == 64);
  BOOST_TEST(hollow.figures.volume_removed == 0.02 * 0.02 * 0.02, tolerance(1e-13));
  BOOST_TEST(hollow.figures.faces_split == 0);
  BOOST_TEST(hollow.figures.nodes_added == 0);
  BOOST_TEST(hollow.figures.area == 0);
}

// Triangles and quadrilaterals of one plane.
BOOST_AUTO_TEST_CASE(other_cells_have_the_same_area) {
  for (const CellPattern pattern :
       {CellPattern::tetrahedron, CellPattern::prism, CellPattern::pyramid}) {
    const MadeCut split = make_cut(cube(pattern), slit(0.025));
    BOOST_TEST(split.figures.area == 0.05 * 0.025, tolerance(1e-13));
    BOOST_TEST(split.figures.nodes_added == 55);
    BOOST_TEST(split.figures.faces_split ==
               split.body.mesh.region("slit-above").faces.size());
  }
}

BOOST_AUTO_TEST_CASE(errors_tell_where_the_cut_was_asked_for) {
  BOOST_CHECK_EXCEPTION(
      make_cut(cube(CellPattern::hexahedron), slit(0.06)), InputError,
      [](const InputError& error) {
        return std::string_view(error.what()).starts_with("here: cut 'slit': expected ");
      });
}

BOOST_AUTO_TEST_SUITE_END()
