#include "meshing/cutting/cut_choice.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(cut_choice_test)

namespace {

const Plane middle{.normal = {0, 0, 1}, .offset = 0.025};

Box box(const Vector3& low, const Vector3& high) {
  return {.low = low, .high = high};
}

Mesh cube(int cells, CellPattern pattern = CellPattern::hexahedron,
          double distortion = 0) {
  return generate_block({.size = {0.05, 0.05, 0.05},
                         .cells = {cells, cells, cells},
                         .pattern = pattern,
                         .distortion = distortion});
}

FaceChoice along(const Mesh& mesh, const CutPlace& where) {
  return faces_along("body", "cut 'c'", CellComplex(mesh), mesh.nodes(), where);
}

std::vector<std::uint32_t> within(const Mesh& mesh, const CutPlace& where) {
  return cells_within("body", "cut 'c'", CellComplex(mesh), mesh.nodes(), where);
}

template <class Choose>
void check_refusal(const Choose& choose, const std::string& message) {
  BOOST_CHECK_EXCEPTION(choose(), InputError, [&](const InputError& error) {
    BOOST_TEST(error.what() == message);
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(plane_between_layers_of_cells_takes_their_faces) {
  const Mesh mesh = cube(10);
  const FaceChoice all = along(mesh, {.surface = middle});
  BOOST_TEST(all.faces.size() == 100);
  BOOST_TEST(all.farthest < 1e-15);
  const CellComplex cells(mesh);
  for (const CellSide& face : all.faces)
    for (const NodeIndex node : cells.nodes_of(face))
      BOOST_TEST(mesh.nodes()[node].z() == 0.025);
  // Half of it, and a window.
  BOOST_TEST(
      along(mesh, {.surface = middle, .within = box({0, 0, 0}, {0.025, 0.05, 0.05})})
          .faces.size() == 50);
  BOOST_TEST(along(mesh, {.surface = Plane{.normal = {1, 0, 0}, .offset = 0.025},
                          .within = box({0, 0, 0.01}, {0.05, 0.025, 0.04})})
                 .faces.size() == 5 * 6);
}

// Through the centres of five layers rounding must not make steps.
BOOST_AUTO_TEST_CASE(centres_on_the_plane_are_above_it) {
  const Mesh mesh = cube(5);
  const FaceChoice choice = along(mesh, {.surface = middle});
  BOOST_TEST(choice.faces.size() == 25);
  BOOST_TEST(choice.farthest == 0.005, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(faces_near_a_plane_part_bodies_of_all_cells_in_two) {
  for (const CellPatternName& pattern : cell_patterns()) {
    const Mesh mesh = cube(4, pattern.value, 0.02);
    CellComplex cells(mesh);
    const Plane tilted{.normal = Vector3(1, 2, 3).normalized(), .offset = 0.04};
    const FaceChoice choice =
        faces_along("", "", cells, mesh.nodes(), {.surface = tilted});
    BOOST_TEST(choice.farthest > 0);
    BOOST_TEST(choice.farthest < 0.025);  // about a cell's diagonal
    cells.part(choice.faces);
    for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
      for (std::uint8_t f = 0; f < cells.face_count(c); ++f)
        if (const std::uint32_t other = cells.across({c, f});
            other != CellComplex::none) {
          const auto height = [&](std::uint32_t cell) {
            Vector3 sum = Vector3::Zero();
            for (const NodeIndex node : mesh.cells()[cell]) sum += mesh.nodes()[node];
            return height_over(tilted,
                               sum / static_cast<double>(mesh.cells()[cell].size()));
          };
          BOOST_TEST((height(c) < 0) == (height(other) < 0));
        }
  }
}

BOOST_AUTO_TEST_CASE(walls_and_blades_take_faces) {
  const Mesh mesh = cube(10);
  BOOST_TEST(along(mesh, {.surface = box({0.01, 0.01, 0.01}, {0.04, 0.04, 0.04})})
                 .faces.size() == 6 * 36);
  // Down from the top to the middle, along x to the middle, then along y.
  const Blade blade{
      .points = {{0, 0.025, 0.05}, {0.025, 0.025, 0.05}, {0.025, 0.05, 0.05}},
      .depth = {0, 0, -0.025}};
  BOOST_TEST(along(mesh, {.surface = blade}).faces.size() == 2 * 25);
  const Cylinder canal{
      .from = {0, 0.025, 0.025}, .to = {0.05, 0.025, 0.025}, .radius = 0.0105};
  // Of each layer the 4 x 4 cells around the axis but those at the corners.
  BOOST_TEST(within(mesh, {.surface = canal}).size() == 12 * 10);
  BOOST_TEST(along(mesh, {.surface = canal}).faces.size() == 16 * 10);
}

BOOST_AUTO_TEST_CASE(cells_within_a_box) {
  const Mesh mesh = cube(10);
  const auto hole = box({0.015, 0.015, 0.015}, {0.035, 0.035, 0.035});
  BOOST_TEST(within(mesh, {.surface = hole}).size() == 64);
  BOOST_TEST(within(mesh, {.surface = hole, .within = box({0, 0, 0}, {0.02, 0.05, 0.05})})
                 .size() == 16);
}

// Rounding must not decide about centres on the walls.
BOOST_AUTO_TEST_CASE(centres_on_a_wall_are_outside) {
  for (int n = 5; n < 14; ++n) {
    const double low = 1.5 / n * 0.05, high = (n - 1.5) / n * 0.05;
    const Box inner = box(Vector3::Constant(low), Vector3::Constant(high));
    BOOST_TEST(within(cube(n), {.surface = inner}).size() == std::pow(n - 4, 3));
    BOOST_TEST(within(cube(n), {.surface = box({-1, -1, -1}, {1, 1, 1}), .within = inner})
                   .size() == std::pow(n - 2, 3));
    BOOST_TEST(along(cube(n), {.surface = Plane{.normal = {0, 0, 1}, .offset = low}})
                   .faces.size() == static_cast<std::size_t>(n * n));
    BOOST_TEST(along(cube(n), {.surface = Plane{.normal = {0, 0, 1}, .offset = low},
                               .within = box({low, low, 0}, {high, high, 1})})
                   .faces.size() == static_cast<std::size_t>((n - 2) * (n - 2)));
  }
  const Mesh mesh = cube(5);
  BOOST_TEST(within(mesh, {.surface = box({0.015, 0.015, 0.015}, {0.035, 0.035, 0.035})})
                 .size() == 1);
  BOOST_TEST(within(mesh, {.surface = box({0, 0, 0}, {0.05, 0.05, 0.05}),
                           .within = box({0.015, 0.015, 0.015}, {0.035, 0.035, 0.035})})
                 .size() == 27);
}

// Where the body is now, not where it was.
BOOST_AUTO_TEST_CASE(positions_may_be_deformed) {
  const Mesh mesh = cube(10);
  std::vector<Vector3> positions = mesh.nodes();
  for (Vector3& x : positions) x.z() *= 1.5;
  const FaceChoice choice =
      faces_along("body", "cut", CellComplex(mesh), positions,
                  {.surface = Plane{.normal = {0, 0, 1}, .offset = 0.0375}});
  BOOST_TEST(choice.faces.size() == 100);
  BOOST_TEST(choice.farthest < 1e-15);
}

BOOST_AUTO_TEST_CASE(surfaces_that_meet_nothing_are_told_what_is_nearest) {
  const Mesh mesh = cube(10);
  check_refusal(
      [&] {
        along(mesh, {.surface = Plane{.normal = {0, 0, 1}, .offset = 0.08}});
      },
      "body: cut 'c': expected a face between cells on its two sides, got none: the "
      "nearest "
      "face between two cells is at (0.0025, 0.0025, 0.045) m, 0.035 m off");
  check_refusal(
      [&] {
        along(mesh, {.surface = middle, .within = box({0.06, 0, 0}, {0.07, 0.05, 0.05})});
      },
      "body: cut 'c': expected a face between cells on its two sides, got none: the "
      "nearest "
      "face between two cells is at (0.0475, 0.0025, 0.025) m, 0.0125 m off");
  check_refusal(
      [&] {
        within(mesh, {.surface = box({0.001, 0, 0}, {0.002, 0.01, 0.01})});
      },
      "body: cut 'c': expected a cell whose centre is inside, got none: the nearest "
      "cell's "
      "centre is at (0.0025, 0.0025, 0.0025) m, 0.0005 m off");
  check_refusal(
      [&] { along(cube(1), {.surface = middle}); },
      "body: cut 'c': expected a face between cells on its two sides, got a body "
      "without faces between two cells");
}

BOOST_AUTO_TEST_SUITE_END()
