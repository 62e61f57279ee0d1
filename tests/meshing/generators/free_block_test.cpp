#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "meshing/generators/generate_block.hpp"
#include "meshing/quality.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(free_block_test)

namespace {

constexpr std::array free_patterns{CellPattern::free_tetrahedron, CellPattern::free_prism,
                                   CellPattern::free_hexahedron, CellPattern::transition};

Block block(CellPattern pattern, std::array<int, 3> cells) {
  return {.size = {0.3, 0.2, 0.7}, .cells = cells, .pattern = pattern};
}

double mean_edge(const Mesh& mesh) {
  double sum = 0, count = 0;
  for (const CellNodes& cell : mesh.cells())
    for (const auto& [a, b] : edges(type_of(cell))) {
      sum += (mesh.nodes()[cell[a]] - mesh.nodes()[cell[b]]).norm();
      ++count;
    }
  return sum / count;
}

}  // namespace

// A face that two cells cut differently would be a boundary face inside the block; a side
// that is not met exactly would have no faces.
BOOST_AUTO_TEST_CASE(cells_fit_together_and_the_regions_are_the_whole_surface) {
  for (const CellPattern pattern : free_patterns)
    for (const auto& cells : {std::array{1, 1, 1}, {1, 2, 3}, {2, 2, 7}, {9, 6, 4}}) {
      const Mesh mesh = generate_block(block(pattern, cells));
      BOOST_TEST_CONTEXT(mesh.source()) {
        std::multiset<FaceNodes> outside, in_regions;
        for (const FaceNodes& face : mesh.boundary().faces)
          outside.insert(ascending(face));
        BOOST_TEST(mesh.regions().size() == 6U);
        for (const auto& [name, region] : mesh.regions())
          for (const FaceNodes& face : region.faces) in_regions.insert(ascending(face));
        BOOST_TEST((outside == in_regions));
        // The tolerance is round-off of sums of some thousand cells.
        BOOST_TEST(mesh.volume() == 0.3 * 0.2 * 0.7, boost::test_tools::tolerance(1e-12));
      }
    }
}

BOOST_AUTO_TEST_CASE(each_pattern_has_its_types) {
  using enum CellType;
  const std::map<CellPattern, std::set<CellType>> expected{
      {CellPattern::free_tetrahedron, {tetrahedron}},
      {CellPattern::free_prism, {prism}},
      {CellPattern::free_hexahedron, {hexahedron}},
      {CellPattern::transition, {tetrahedron, pyramid, hexahedron}}};
  for (const auto& [pattern, types] : expected) {
    const Mesh mesh = generate_block(block(pattern, {6, 4, 14}));
    std::set<CellType> found;
    for (const CellNodes& cell : mesh.cells()) found.insert(type_of(cell));
    BOOST_TEST((found == types));
  }
}

BOOST_AUTO_TEST_CASE(equal_blocks_get_equal_meshes) {
  for (const CellPattern pattern : free_patterns) {
    const std::string hash = generate_block(block(pattern, {6, 4, 14})).sha256();
    static_cast<void>(generate_block(block(CellPattern::free_hexahedron, {3, 3, 3})));
    BOOST_TEST(generate_block(block(pattern, {6, 4, 14})).sha256() == hash);
  }
}

// The cells are of 0.05 m each way. The longer edges of tetrahedra belong to more of
// them; lines from the middle of a tetrahedron are shorter than half its edge.
BOOST_AUTO_TEST_CASE(edges_are_about_as_long_as_asked_for) {
  for (const CellPattern pattern : free_patterns) {
    const double edge = mean_edge(generate_block(block(pattern, {6, 4, 14})));
    BOOST_TEST(edge > 0.6 * 0.05);
    BOOST_TEST(edge < 1.4 * 0.05);
  }
}

BOOST_AUTO_TEST_CASE(prisms_stand_in_as_many_layers_as_there_are_cells_along_z) {
  const Mesh mesh = generate_block(block(CellPattern::free_prism, {6, 4, 5}));
  const std::size_t triangles = mesh.region("bottom").faces.size();
  BOOST_TEST(mesh.cells().size() == 5 * triangles);
  BOOST_TEST(mesh.nodes().size() == 6 * mesh.region("bottom").nodes.size());
}

// Of ten layers four are hexahedra, and one is cut around its centres.
BOOST_AUTO_TEST_CASE(transition_has_hexahedra_in_the_lower_half_and_pyramids_on_them) {
  const Mesh mesh = generate_block(block(CellPattern::transition, {4, 3, 10}));
  BOOST_TEST(mesh.count(CellType::hexahedron) == 4U * 3 * 4);
  BOOST_TEST(mesh.count(CellType::pyramid) == 4U * 3);
  for (const CellNodes& cell : mesh.cells())
    if (type_of(cell) == CellType::pyramid)
      for (std::size_t corner = 0; corner < 4; ++corner)
        BOOST_TEST(mesh.nodes()[cell[corner]].z() == 0.7 * 4 / 10,
                   boost::test_tools::tolerance(1e-14));
}

// Bands around what gmsh 4.8.4 gives here: .22, .79, .13, .21.
BOOST_AUTO_TEST_CASE(no_cell_is_worse_than_a_tenth_of_a_regular_one) {
  for (const CellPattern pattern : free_patterns) {
    const Mesh mesh =
        generate_block({.size = {1, 1, 1}, .cells = {10, 10, 10}, .pattern = pattern});
    BOOST_TEST(quality_of(mesh).all.smallest_scaled_jacobian > 0.1, mesh.source());
  }
}

BOOST_AUTO_TEST_CASE(distortion_moves_the_nodes_inside_alone) {
  for (const CellPattern pattern : free_patterns) {
    Block distorted = block(pattern, {6, 4, 14});
    const Mesh regular = generate_block(distorted);
    distorted.distortion = 0.02;
    const Mesh mesh = generate_block(distorted);
    BOOST_TEST(mesh.sha256() != regular.sha256());
    BOOST_TEST(mesh.boundary().faces.size() == regular.boundary().faces.size());
    for (const auto& [name, region] : regular.regions()) {
      BOOST_TEST(mesh.region(name).faces.size() == region.faces.size());
    }
    // The surface stays: round-off.
    BOOST_TEST(mesh.volume() == regular.volume(), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
