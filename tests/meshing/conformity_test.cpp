#include "meshing/conformity.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(conformity_test)

namespace {

/// Corners of a box in a cell's order.
std::vector<Vector3> box(const Vector3& low, const Vector3& high) {
  std::vector<Vector3> corners;
  for (const double z : {low.z(), high.z()})
    for (const auto& [x, y] : {std::pair{low.x(), low.y()},
                               {high.x(), low.y()},
                               {high.x(), high.y()},
                               {low.x(), high.y()}})
      corners.emplace_back(x, y, z);
  return corners;
}

/// Nodes 0 to 7, a unit cube, and what is on it from node 8 on.
Mesh on_cube(const std::vector<Vector3>& more, std::vector<CellNodes> cells) {
  std::vector<Vector3> nodes = box({0, 0, 0}, {1, 1, 1});
  nodes.insert(nodes.end(), more.begin(), more.end());
  cells.push_back({0, 1, 2, 3, 4, 5, 6, 7});
  return {"body", nodes, cells, {}};
}

const CellNodes second_cube{8, 9, 10, 11, 12, 13, 14, 15};

void check_refusal(const Mesh& mesh, const std::string& message) {
  BOOST_CHECK_EXCEPTION(check_conformity(mesh), InputError, [&](const InputError& error) {
    BOOST_TEST(error.what() == message);
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(blocks_of_all_patterns_pass) {
  for (const CellPatternName& pattern : cell_patterns())
    for (const double distortion : {0., 0.02})
      BOOST_CHECK_NO_THROW(check_conformity(generate_block({.size = {0.3, 0.2, 0.7},
                                                            .cells = {3, 4, 5},
                                                            .pattern = pattern.value,
                                                            .distortion = distortion})));
}

BOOST_AUTO_TEST_CASE(thin_and_single_cells_pass) {
  BOOST_CHECK_NO_THROW(
      check_conformity(generate_block({.size = {1, 1, 1e-3}, .cells = {1, 1, 1}})));
  BOOST_CHECK_NO_THROW(check_conformity(
      Mesh("one", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {})));
}

BOOST_AUTO_TEST_CASE(bodies_apart_pass) {
  BOOST_CHECK_NO_THROW(
      check_conformity(on_cube(box({0, 0, 1.001}, {1, 1, 2}), {second_cube})));
}

// The second cube shares a face's place but not its nodes: never merged, or cracked.
BOOST_AUTO_TEST_CASE(two_nodes_in_one_place_are_refused) {
  check_refusal(on_cube(box({0, 0, 1}, {1, 1, 2}), {second_cube}),
                "body: node 5: expected a place of its own, or cells merged there, got "
                "node 9 in the same place");
  // Nodes as near as coordinates printed to six digits are refused too.
  check_refusal(on_cube(box({1e-6, 0, 1}, {1.5, 1.5, 2}), {second_cube}),
                "body: node 5: expected a place of its own, or cells merged there, got "
                "node 9 in the same place");
}

BOOST_AUTO_TEST_CASE(node_hanging_in_a_face_is_refused) {
  check_refusal(on_cube(box({0.2, 0.3, 1}, {0.4, 0.6, 2}), {second_cube}),
                "body: node 9: expected a corner of every face that it lies in, got it "
                "inside the face of node 5, node 6, node 7, node 8");
}

// A prism has one corner on the middle of an edge of the cube, and two of its own.
BOOST_AUTO_TEST_CASE(node_hanging_on_an_edge_is_refused) {
  check_refusal(
      on_cube({{0.5, 1, 1}, {0.5, 1, 2}, {0, 0, 2}, {1, 0, 2}}, {{4, 5, 8, 10, 11, 9}}),
      "body: node 9: expected a corner of every face that it lies in, got it inside the "
      "face of node 5, node 6, node 7, node 8");
}

// Two prisms on the cube, which has one quadrilateral against their two triangles.
BOOST_AUTO_TEST_CASE(quadrilateral_against_two_triangles_is_refused) {
  check_refusal(on_cube({{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}},
                        {{4, 5, 6, 8, 9, 10}, {4, 6, 7, 8, 10, 11}}),
                "body: quadrilateral of node 5, node 6, node 7, node 8: expected a "
                "quadrilateral against it, got triangles with an edge from node 5 to "
                "node 7");
}

// Prisms above and below, cut along different diagonals, flat or warped between them.
BOOST_AUTO_TEST_CASE(triangles_along_different_diagonals_are_refused) {
  for (const double warp : {0., 0.1, -0.1}) {
    std::vector<Vector3> nodes;
    for (const double z : {0., 1., 2.})
      for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
        nodes.emplace_back(x, y, z);
    nodes[4].z() += warp;
    check_refusal(Mesh("body", nodes,
                       {{0, 1, 2, 4, 5, 6},
                        {0, 2, 3, 4, 6, 7},
                        {4, 5, 7, 8, 9, 11},
                        {5, 6, 7, 9, 10, 11}},
                       {}),
                  "body: triangles of node 5, node 6, node 7, node 8: expected two cut "
                  "along the same diagonal, got two pairs cut along different ones");
  }
}

// A node in a warped quadrilateral, and one as far off it as it is warped.
BOOST_AUTO_TEST_CASE(warped_faces_are_the_bilinear_ones) {
  std::vector<Vector3> nodes = box({0, 0, 0}, {1, 1, 1});
  nodes[6].z() = 1.4;  // the patch is at 1 + 0.4 x y
  const auto with_box_at = [&](double z) {
    std::vector<Vector3> all = nodes;
    // Only the first corner is near the face.
    for (const Vector3& x : box({0.2, 0.9, z}, {0.3, 1, 3})) all.push_back(x);
    all[9].z() = all[10].z() = all[11].z() = 2;
    return Mesh("body", all, {{0, 1, 2, 3, 4, 5, 6, 7}, second_cube}, {});
  };
  check_refusal(with_box_at(1 + 0.4 * 0.2 * 0.9),
                "body: node 9: expected a corner of every face that it lies in, got it "
                "inside the face of node 5, node 6, node 7, node 8");
  BOOST_CHECK_NO_THROW(check_conformity(with_box_at(1.2)));
}

BOOST_AUTO_TEST_CASE(errors_name_nodes_as_they_are_told_to) {
  BOOST_CHECK_EXCEPTION(
      check_conformity(on_cube(box({0, 0, 1}, {1, 1, 2}), {second_cube}),
                       [](NodeIndex node) { return fmt::format("#{}", 10 * node); }),
      InputError, [](const InputError& error) {
        BOOST_TEST(error.what() ==
                   std::string("body: #40: expected a place of its own, or cells merged "
                               "there, got #80 in the same place"));
        return true;
      });
}

BOOST_AUTO_TEST_SUITE_END()
