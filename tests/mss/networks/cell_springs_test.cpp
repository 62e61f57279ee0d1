#include "mss/networks/cell_springs.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "meshing/mesh.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(cell_springs_test)

namespace {

/// Corner i of the unit cube, in the order of CellNodes.
Vector3 corner(std::size_t i) {
  constexpr std::array<std::array<int, 3>, 8> places{{{0, 0, 0},
                                                      {1, 0, 0},
                                                      {1, 1, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {1, 0, 1},
                                                      {1, 1, 1},
                                                      {0, 1, 1}}};
  return {static_cast<double>(places[i][0]), static_cast<double>(places[i][1]),
          static_cast<double>(places[i][2])};
}

Vector3 along(const LocalEdge& pair) {
  return corner(pair[1]) - corner(pair[0]);
}

}  // namespace

// Lengths in the unit cube tell edges, face and inner diagonals apart.
BOOST_AUTO_TEST_CASE(hexahedron_has_twelve_edges_twelve_face_and_four_inner_diagonals) {
  std::set<std::set<std::size_t>> pairs;
  const auto check = [&](const auto& springs, double squared_length) {
    for (const LocalEdge& pair : springs) {
      BOOST_TEST(along(pair).squaredNorm() == squared_length);
      pairs.insert({pair[0], pair[1]});
    }
  };
  check(edges(CellType::hexahedron), 1);
  check(face_diagonals(CellType::hexahedron), 2);
  check(inner_diagonals(CellType::hexahedron), 3);
  BOOST_TEST(pairs.size() == 28U);  // all of the 8 * 7/2 there are
}

// Golec 2018, section 6.1: 0, 2, 6 and 12 face diagonals, and inner ones in hexahedra.
BOOST_AUTO_TEST_CASE(cells_have_the_springs_of_the_thesis) {
  struct Row {
    CellType type;
    std::size_t edges, face_diagonals, inner_diagonals;
  };
  for (const Row& row :
       {Row{CellType::tetrahedron, 6, 0, 0}, Row{CellType::pyramid, 8, 2, 0},
        Row{CellType::prism, 9, 6, 0}, Row{CellType::hexahedron, 12, 12, 4}})
    BOOST_TEST_CONTEXT(name_of(row.type)) {
      std::set<std::set<std::size_t>> pairs;
      const auto add = [&](const auto& springs, std::size_t expected) {
        BOOST_TEST(springs.size() == expected);
        for (const LocalEdge& pair : springs) {
          BOOST_TEST(std::max(pair[0], pair[1]) < node_count(row.type));
          pairs.insert({pair[0], pair[1]});
        }
      };
      add(edges(row.type), row.edges);
      add(face_diagonals(row.type), row.face_diagonals);
      add(inner_diagonals(row.type), row.inner_diagonals);
      BOOST_TEST(pairs.size() == row.edges + row.face_diagonals + row.inner_diagonals);
    }
}

BOOST_AUTO_TEST_CASE(directions_are_those_along_edges_and_across_faces) {
  for (const LocalEdge& edge : edges(CellType::hexahedron))
    BOOST_TEST(std::abs(along(edge)[static_cast<Eigen::Index>(edge_direction(edge))]) ==
               1);
  for (const LocalEdge& diagonal : face_diagonals(CellType::hexahedron))
    BOOST_TEST(along(diagonal)[static_cast<Eigen::Index>(face_direction(diagonal))] == 0);
}

BOOST_AUTO_TEST_SUITE_END()
