#include <gmsh.h>

#include <boost/test/unit_test.hpp>
#include <map>

#include "meshing/cutting/cut_body.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/gmsh/session.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(crack_test)

namespace {

constexpr double length = 4;

Mesh body_of_tetrahedra() {
  return generate_block({.size = {length, length, length},
                         .cells = {4, 4, 4},
                         .pattern = CellPattern::tetrahedron});
}

/// The faces at z = 2 from x = 0 to x = `end`, as the cells below have them.
std::vector<CellSide> slit(const Mesh& body, const CellComplex& cells, double end) {
  std::vector<CellSide> slit;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f) {
      const FaceNodes nodes = cells.nodes_of(CellSide{c, f});
      const auto is_there = [&](NodeIndex node) {
        return body.nodes()[node].z() == 2 && body.nodes()[node].x() <= end;
      };
      const auto is_above = [&](NodeIndex node) { return body.nodes()[node].z() > 2; };
      if (std::ranges::all_of(nodes, is_there) &&
          std::ranges::none_of(cells.nodes_of(c), is_above))
        slit.push_back({c, f});
    }
  return slit;
}

std::vector<std::size_t> tags_of(const std::vector<FaceNodes>& lists) {
  std::vector<std::size_t> tags;
  for (const FaceNodes& list : lists)
    for (const NodeIndex node : list) tags.push_back(node + 1);
  return tags;
}

/// Nodes of the tetrahedra after gmsh's plugin Crack has opened the faces, by fours.
std::vector<std::size_t> cracked_by_gmsh(const Mesh& body,
                                         const std::vector<FaceNodes>& faces,
                                         double end) {
  const GmshSession session("crack");
  namespace model = ::gmsh::model;
  // Where the crack meets the surface it is open; else it would stay closed there.
  std::vector<FaceNodes> open;
  for (const FaceNodes& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const NodeIndex a = face[i], b = face[(i + 1) % 3];
      const Vector3 &x = body.nodes()[a], &y = body.nodes()[b];
      const auto both_at = [&](Eigen::Index axis, double place) {
        return x[axis] == place && y[axis] == place;
      };
      if (both_at(0, 0) || both_at(1, 0) || both_at(1, length) ||
          (end == length && both_at(0, length)))
        open.push_back({a, b});
    }
  const int volume = model::addDiscreteEntity(3), surface = model::addDiscreteEntity(2),
            line = model::addDiscreteEntity(1);
  std::vector<std::size_t> tags;
  std::vector<double> places;
  for (const Vector3& x : body.nodes()) {
    tags.push_back(tags.size() + 1);
    places.insert(places.end(), x.begin(), x.end());
  }
  model::mesh::addNodes(3, volume, tags, places);
  std::vector<std::size_t> cells;
  for (const CellNodes& cell : body.cells())
    for (const NodeIndex node : cell) cells.push_back(node + 1);
  model::mesh::addElementsByType(volume, 4, {}, cells);
  model::mesh::addElementsByType(surface, 2, {}, tags_of(faces));
  model::mesh::addElementsByType(line, 1, {}, tags_of(open));
  ::gmsh::plugin::setNumber("Crack", "Dimension", 2);
  ::gmsh::plugin::setNumber("Crack", "PhysicalGroup",
                            model::addPhysicalGroup(2, {surface}));
  ::gmsh::plugin::setNumber("Crack", "OpenBoundaryPhysicalGroup",
                            model::addPhysicalGroup(1, {line}));
  ::gmsh::plugin::run("Crack");
  std::vector<std::size_t> nodes;
  std::vector<std::size_t> numbers;
  model::mesh::getElementsByType(4, numbers, nodes);
  return nodes;
}

}  // namespace

// Referee: gmsh's plugin Crack, on a slit to the middle and on one right through.
BOOST_AUTO_TEST_CASE(tetrahedra_part_as_gmsh_cracks_them) {
  for (const double end : {2., length}) {
    const Mesh body = body_of_tetrahedra();
    const CellComplex cells(body);
    const Cut wanted{.name = "slit", .parted = slit(body, cells, end)};
    BOOST_TEST(wanted.parted.size() == 8 * static_cast<std::size_t>(end));
    std::vector<FaceNodes> faces;
    for (const CellSide& face : wanted.parted) faces.push_back(cells.nodes_of(face));
    const CutBody ours = cut("", body, CellComplex(body), wanted);
    const std::vector<std::size_t> theirs = cracked_by_gmsh(body, faces, end);

    BOOST_TEST_REQUIRE(theirs.size() == 4 * body.cells().size());
    std::map<std::size_t, NodeIndex> node_of_tag;
    std::map<NodeIndex, std::size_t> tag_of_node;
    for (std::size_t c = 0; c < body.cells().size(); ++c)
      for (std::size_t i = 0; i < 4; ++i) {
        const NodeIndex node = ours.mesh.cells()[c][i];
        const std::size_t tag = theirs[4 * c + i];
        BOOST_TEST_REQUIRE(node_of_tag.emplace(tag, node).first->second == node);
        BOOST_TEST_REQUIRE(tag_of_node.emplace(node, tag).first->second == tag);
      }
    BOOST_TEST(tag_of_node.size() == ours.mesh.nodes().size());
    // Two, or all, of the columns of five nodes at z = 2.
    BOOST_TEST(ours.mesh.nodes().size() - body.nodes().size() ==
               (end == length ? 25 : 10));
  }
}

BOOST_AUTO_TEST_SUITE_END()
