#include "dynamics/blocks/hexahedron_grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "meshing/generators/generate_block.hpp"
#include "tests/dynamics/blocks/shuffled_cells.hpp"

using namespace springcheck;
using namespace springcheck::dynamics;

BOOST_AUTO_TEST_SUITE(hexahedron_grid_test)

namespace {

Mesh block(CellPattern pattern, double distortion = 0) {
  return generate_block({.size = {3, 4, 5},
                         .cells = {3, 4, 5},
                         .pattern = pattern,
                         .distortion = distortion});
}

std::array<int, 3> place_of(const GridCell& cell, int corner) {
  return {cell.at[0] + (corner & 1), cell.at[1] + (corner >> 1 & 1),
          cell.at[2] + (corner >> 2)};
}

/// Corners are the cell's nodes and right-handed, cells with a common face are of one
/// body, and in a body every place has one node and every node one place: neighbours in
/// the mesh are neighbours in the grid, and the other way round.
void check_grid(const Mesh& mesh) {
  const auto grid = grid_of(mesh);
  BOOST_TEST_REQUIRE(grid.has_value());
  BOOST_TEST_REQUIRE(grid->size() == mesh.cells().size());
  std::map<std::pair<std::uint32_t, std::array<int, 3>>, NodeIndex> node_at;
  std::map<std::pair<std::uint32_t, NodeIndex>, std::array<int, 3>> place_at;
  std::map<std::set<NodeIndex>, std::uint32_t> body_at;
  bool right_handed = true, same_nodes = true, one_to_one = true, one_body = true;
  for (std::size_t c = 0; c < grid->size(); ++c) {
    const GridCell& cell = (*grid)[c];
    const CellNodes& nodes = mesh.cells()[c];
    same_nodes = same_nodes && std::set(cell.corners.begin(), cell.corners.end()) ==
                                   std::set(nodes.begin(), nodes.end());
    const auto edge = [&](std::size_t corner) {
      return Vector3(mesh.nodes()[cell.corners[corner]] - mesh.nodes()[cell.corners[0]]);
    };
    right_handed = right_handed && edge(1).dot(edge(2).cross(edge(4))) > 0;
    for (int corner = 0; corner < 8; ++corner) {
      const NodeIndex node = cell.corners[static_cast<std::size_t>(corner)];
      const auto place = place_of(cell, corner);
      one_to_one = one_to_one &&
                   node_at.try_emplace({cell.body, place}, node).first->second == node &&
                   place_at.try_emplace({cell.body, node}, place).first->second == place;
    }
    for (const LocalFace& face : faces(CellType::hexahedron)) {
      const FaceNodes of_face = face_nodes(nodes, face);
      one_body = one_body &&
                 body_at.try_emplace(std::set(of_face.begin(), of_face.end()), cell.body)
                         .first->second == cell.body;
    }
  }
  BOOST_TEST(same_nodes);
  BOOST_TEST(right_handed);
  BOOST_TEST(one_to_one);
  BOOST_TEST(one_body);
}

std::size_t body_count(const Mesh& mesh) {
  std::set<std::uint32_t> bodies;
  const auto grid = grid_of(mesh);
  BOOST_TEST_REQUIRE(grid.has_value());
  for (const GridCell& cell : *grid) bodies.insert(cell.body);
  return bodies.size();
}

/// Quadrilaterals in the plane, made into a layer of hexahedra.
Mesh layer(const std::vector<std::array<double, 2>>& points,
           const std::vector<std::array<NodeIndex, 4>>& quadrilaterals) {
  std::vector<Vector3> nodes;
  for (const double z : {0., 1.})
    for (const auto& [x, y] : points) nodes.emplace_back(x, y, z);
  std::vector<CellNodes> cells;
  for (const auto& corners : quadrilaterals) {
    CellNodes cell;
    for (const std::size_t below : {std::size_t{0}, points.size()})
      for (const NodeIndex corner : corners)
        cell.push_back(static_cast<NodeIndex>(corner + below));
    cells.push_back(cell);
  }
  return Mesh("layer", std::move(nodes), std::move(cells), {});
}

std::array<double, 2> at_angle(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Cells that meet at an axis.
Mesh around_an_axis(NodeIndex count) {
  std::vector<std::array<double, 2>> points{{0, 0}};
  std::vector<std::array<NodeIndex, 4>> cells;
  for (NodeIndex i = 0; i < count; ++i) {
    points.push_back(at_angle(1, (i + 0.) / count));
    points.push_back(at_angle(1.5, (i + .5) / count));
    cells.push_back({0, 1 + 2 * i, 2 + 2 * i, 1 + 2 * ((i + 1) % count)});
  }
  return layer(points, cells);
}

/// Some of the cells of a ring around a hole, each the neighbour of the last.
Mesh ring(NodeIndex places, NodeIndex count) {
  std::vector<std::array<double, 2>> points;
  for (NodeIndex i = 0; i < std::min(places, count + 1); ++i) {
    points.push_back(at_angle(1, (i + 0.) / places));
    points.push_back(at_angle(2, (i + 0.) / places));
  }
  std::vector<std::array<NodeIndex, 4>> cells;
  for (NodeIndex i = 0; i < count; ++i) {
    const NodeIndex next = (i + 1) % places;
    cells.push_back({2 * i, 2 * i + 1, 2 * next + 1, 2 * next});
  }
  return layer(points, cells);
}

/// Unit cubes at these places.
Mesh cubes(const std::vector<std::array<int, 3>>& places) {
  std::map<std::array<int, 3>, NodeIndex> number;
  std::vector<Vector3> nodes;
  std::vector<CellNodes> cells;
  for (const auto& [x, y, z] : places) {
    CellNodes cell;
    for (const auto& [i, j, k] : std::initializer_list<std::array<int, 3>>{{0, 0, 0},
                                                                           {1, 0, 0},
                                                                           {1, 1, 0},
                                                                           {0, 1, 0},
                                                                           {0, 0, 1},
                                                                           {1, 0, 1},
                                                                           {1, 1, 1},
                                                                           {0, 1, 1}}) {
      const std::array<int, 3> place{x + i, y + j, z + k};
      const auto [entry, is_new] =
          number.try_emplace(place, static_cast<NodeIndex>(nodes.size()));
      if (is_new) nodes.emplace_back(place[0], place[1], place[2]);
      cell.push_back(entry->second);
    }
    cells.push_back(cell);
  }
  return Mesh("cubes", std::move(nodes), std::move(cells), {});
}

}  // namespace

BOOST_AUTO_TEST_CASE(neighbours_are_neighbours_whatever_the_numbers_and_shapes) {
  check_grid(block(CellPattern::hexahedron));
  check_grid(block(CellPattern::hexahedron, .2));
  for (unsigned seed = 1; seed < 6; ++seed)
    for (const double kept : {.2, .6, 1.})
      check_grid(shuffled_cells({even(7, 1), graded(6, 1), even(5, 1)}, kept, seed));
}

BOOST_AUTO_TEST_CASE(cells_of_other_types_and_free_hexahedra_have_no_grid) {
  BOOST_TEST(!grid_of(block(CellPattern::free_hexahedron)).has_value());
  BOOST_TEST(!grid_of(block(CellPattern::tetrahedron)).has_value());
  BOOST_TEST(!grid_of(block(CellPattern::mixed)).has_value());
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_at_an_edge_or_a_node_have_grids_of_their_own) {
  const Mesh at_edge = cubes({{0, 0, 0}, {1, 1, 0}}),
             at_node = cubes({{0, 0, 0}, {1, 1, 1}});
  for (const Mesh* mesh : {&at_edge, &at_node}) {
    check_grid(*mesh);
    BOOST_TEST(body_count(*mesh) == 2U);
  }
  const Mesh in_one = cubes({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}});
  check_grid(in_one);
  BOOST_TEST(body_count(in_one) == 1U);
}

BOOST_AUTO_TEST_CASE(four_cells_meet_at_an_axis_of_a_grid_and_no_other_number) {
  check_grid(around_an_axis(4));
  for (const NodeIndex count : {3U, 5U, 6U, 8U})
    BOOST_TEST(!grid_of(around_an_axis(count)).has_value(), count);
}

// Eight cells around a missing one turn four corners, and the grid with them; those of a
// ring that goes straight on come back at another place.
BOOST_AUTO_TEST_CASE(a_ring_has_a_grid_unless_it_closes_on_itself) {
  check_grid(cubes({{0, 0, 0},
                    {1, 0, 0},
                    {2, 0, 0},
                    {2, 1, 0},
                    {2, 2, 0},
                    {1, 2, 0},
                    {0, 2, 0},
                    {0, 1, 0}}));
  check_grid(ring(8, 7));
  for (const NodeIndex count : {4U, 5U, 8U})
    BOOST_TEST(!grid_of(ring(count, count)).has_value(), count);
}

BOOST_AUTO_TEST_SUITE_END()
