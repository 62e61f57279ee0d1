#include "meshing/mesh.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(mesh_test)

namespace {

/// Two unit cubes, one on top of the other: all a Mesh is made from.
struct Parts {
  std::vector<Vector3> nodes;
  std::vector<CellNodes> cells{{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}};
  std::map<std::string, std::vector<FaceNodes>> regions{
      {"bottom", {{0, 3, 2, 1}}}, {"side", {{0, 1, 5, 4}, {4, 5, 9, 8}}}};
};

Parts tower() {
  Parts parts;
  for (const double z : {0., 1., 2.})
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      parts.nodes.emplace_back(x, y, z);
  return parts;
}

Mesh built(const Parts& parts) {
  return {"tower", parts.nodes, parts.cells, parts.regions};
}

void check_refusal(const Parts& parts, const std::string& message) {
  BOOST_CHECK_EXCEPTION(built(parts), InputError, [&](const InputError& error) {
    BOOST_TEST(error.what() == message);
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(sound_mesh_keeps_what_it_was_given) {
  const Parts parts = tower();
  const Mesh mesh = built(parts);
  BOOST_TEST(mesh.source() == "tower");
  BOOST_TEST((mesh.nodes() == parts.nodes));
  BOOST_TEST((mesh.cells() == parts.cells));
  BOOST_TEST(mesh.cell_volumes() == std::vector<double>({1, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(mesh.volume() == 2);
  BOOST_TEST(mesh.regions().size() == 2U);
}

BOOST_AUTO_TEST_CASE(region_lists_each_of_its_nodes_once_in_ascending_order) {
  BOOST_TEST(
      built(tower()).region("side").nodes == (std::vector<NodeIndex>{0, 1, 4, 5, 8, 9}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(mesh_without_cells_is_refused) {
  Parts parts = tower();
  parts.cells.clear();
  check_refusal(parts, "tower: cells: expected at least 1, got 0");
}

BOOST_AUTO_TEST_CASE(node_number_out_of_range_is_refused) {
  Parts parts = tower();
  parts.cells[1][7] = 12;
  check_refusal(parts, "tower: hexahedron 2: expected node numbers up to 12, got 13");
}

BOOST_AUTO_TEST_CASE(node_that_no_cell_uses_is_refused) {
  Parts parts = tower();
  parts.nodes.emplace_back(5, 5, 5);
  check_refusal(parts, "tower: node 13: expected a cell that uses it, got none");
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_refused) {
  for (const double bad : {std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    Parts parts = tower();
    parts.nodes[3].y() = bad;
    check_refusal(parts,
                  "tower: node 4: expected finite coordinates, got infinity or "
                  "not-a-number");
  }
}

BOOST_AUTO_TEST_CASE(inverted_cell_is_refused_with_its_place) {
  Parts parts = tower();
  std::swap_ranges(parts.cells[1].begin(), parts.cells[1].begin() + 4,
                   parts.cells[1].begin() + 4);
  check_refusal(parts,
                "tower: hexahedron 2 near (0.5, 0.5, 1.5) m: expected positive Jacobians "
                "at its corners, got -1 m^3");
}

// The cell's volume is positive: only its corner Jacobian gives it away.
BOOST_AUTO_TEST_CASE(cell_folded_at_one_corner_is_refused) {
  Parts parts = tower();
  parts.nodes[0] = Vector3::Constant(0.5);
  check_refusal(parts,
                "tower: hexahedron 1 near (0.5625, 0.5625, 0.5625) m: expected positive "
                "Jacobians at its corners, got -0.5 m^3");
}

BOOST_AUTO_TEST_CASE(flat_cell_is_refused) {
  Parts parts = tower();
  for (std::size_t i = 8; i < 12; ++i) parts.nodes[i].z() = 1;
  check_refusal(
      parts,
      "tower: hexahedron 2 near (0.5, 0.5, 1) m: expected positive Jacobians at "
      "its corners, got 0 m^3");
}

BOOST_AUTO_TEST_CASE(third_cell_at_a_face_is_refused) {
  Parts parts = tower();
  for (std::size_t i = 8; i < 12; ++i)
    parts.nodes.emplace_back(parts.nodes[i] + Vector3::UnitZ());
  parts.cells.push_back({4, 5, 6, 7, 12, 13, 14, 15});
  check_refusal(parts,
                "tower: hexahedron 3 near (0.5, 0.5, 2) m: expected at most two cells at "
                "each of its faces, got three");
}

BOOST_AUTO_TEST_CASE(region_without_faces_is_refused) {
  Parts parts = tower();
  parts.regions["empty"];
  check_refusal(parts, "tower: region 'empty': expected at least 1 face, got 0");
}

BOOST_AUTO_TEST_CASE(region_face_inside_the_body_is_refused) {
  Parts parts = tower();
  parts.regions["middle"] = {{4, 5, 6, 7}};
  check_refusal(
      parts,
      "tower: region 'middle': face of nodes 5, 6, 7, 8: expected a face of exactly one "
      "cell, got a face inside the body");
}

BOOST_AUTO_TEST_CASE(region_face_of_no_cell_is_refused) {
  Parts parts = tower();
  parts.regions["diagonal"] = {{0, 2, 6, 4}};
  check_refusal(parts,
                "tower: region 'diagonal': face of nodes 1, 3, 7, 5: expected a face of "
                "exactly one "
                "cell, got a face of none");
}

BOOST_AUTO_TEST_CASE(unknown_region_lists_the_known_ones) {
  const Mesh mesh = built(tower());
  BOOST_CHECK_EXCEPTION(
      static_cast<void>(mesh.region("lid")), InputError, [](const InputError& error) {
        BOOST_TEST(error.what() ==
                   std::string("tower: region: expected one of bottom, side, "
                               "got 'lid'"));
        return true;
      });
}

BOOST_AUTO_TEST_CASE(hash_changes_with_nodes_cells_and_regions_but_not_with_the_source) {
  const Parts parts = tower();
  const std::string hash = built(parts).sha256();
  BOOST_TEST(hash.size() == 64U);
  BOOST_TEST(hash == Mesh("other", parts.nodes, parts.cells, parts.regions).sha256());

  Parts moved = parts;
  moved.nodes[11].z() = std::nextafter(2, 3);
  Parts reordered = parts;
  std::swap(reordered.cells[0], reordered.cells[1]);
  Parts renamed = parts;
  renamed.regions["Bottom"] = parts.regions.at("bottom");
  renamed.regions.erase("bottom");
  Parts elsewhere = parts;
  elsewhere.regions["bottom"] = {{1, 2, 6, 5}};
  for (const Parts& other : {moved, reordered, renamed, elsewhere})
    BOOST_TEST(hash != built(other).sha256());
}

// They are links in HDF5, words in JSON and lines in messages.
BOOST_AUTO_TEST_CASE(names_of_regions_are_checked) {
  const auto named = [](const std::string& name) {
    Parts parts = tower();
    parts.regions[name] = parts.regions.at("bottom");
    return built(parts);
  };
  for (const char* name : {"foot/left", "/provenance/evil", ".", "..", "50 %", "Füße"})
    BOOST_CHECK_NO_THROW(named(name));
  for (const std::string& name :
       {std::string(), std::string("a\nb"), std::string("a\0b", 3), std::string("\x7f"),
        std::string("\xff"), std::string(1001, 'a')})
    BOOST_CHECK_EXCEPTION(named(name), InputError, [](const InputError& error) {
      return std::string(error.what()).find("expected a name of 1 to 1000 bytes") !=
             std::string::npos;
    });
}

BOOST_AUTO_TEST_SUITE_END()
