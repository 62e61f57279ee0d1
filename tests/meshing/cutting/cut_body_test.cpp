#include "meshing/cutting/cut_body.hpp"

#include <boost/test/unit_test.hpp>
#include <map>
#include <numeric>

#include "meshing/basics/input_error.hpp"
#include "meshing/conformity.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/meshing/cutting/random_cuts.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(cut_body_test)

namespace {

Mesh cube(int cells_a_side) {
  return generate_block(
      {.size = {0.05, 0.05, 0.05}, .cells = {cells_a_side, cells_a_side, cells_a_side}});
}

Vector3 centre(const Mesh& mesh, std::uint32_t cell) {
  Vector3 sum = Vector3::Zero();
  for (const NodeIndex node : mesh.cells()[cell]) sum += mesh.nodes()[node];
  return sum / static_cast<double>(mesh.cells()[cell].size());
}

/// The cube's slit at z = 2.5 cm, x < 2.5 cm.
Cut slit(const Mesh& cube) {
  const CellComplex cells(cube);
  Cut slit{.name = "slit"};
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f) {
      const std::uint32_t other = cells.across({c, f});
      if (other != CellComplex::none && centre(cube, c).x() < 0.025 &&
          centre(cube, c).z() < 0.025 && centre(cube, other).z() > 0.025)
        slit.parted.push_back({c, f});
    }
  return slit;
}

/// The cube's cavity of 2 cm.
Cut cavity(const Mesh& cube) {
  Cut cavity{.name = "cavity"};
  for (std::uint32_t c = 0; c < cube.cells().size(); ++c)
    if ((centre(cube, c) - Vector3::Constant(0.025)).cwiseAbs().maxCoeff() < 0.01)
      cavity.removed.push_back(c);
  return cavity;
}

/// Each edge of the surface is gone along as often one way as the other.
bool is_closed(const std::vector<FaceNodes>& surface) {
  std::map<std::pair<NodeIndex, NodeIndex>, int> excess;
  for (const FaceNodes& face : surface)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const NodeIndex a = face[i], b = face[(i + 1) % face.size()];
      excess[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::ranges::all_of(excess, [](const auto& edge) { return edge.second == 0; });
}

void check_refusal(const Mesh& body, const Cut& wrong, const std::string& message) {
  BOOST_CHECK_EXCEPTION(cut("here", body, CellComplex(body), wrong), InputError,
                        [&](const InputError& error) {
                          BOOST_TEST(error.what() == message);
                          return true;
                        });
}

}  // namespace

BOOST_AUTO_TEST_CASE(slit_has_the_faces_and_nodes_of_the_prototype) {
  const std::map<int, std::pair<std::size_t, std::size_t>> expected{
      {10, {50, 55}}, {20, {200, 210}}, {40, {800, 820}}};
  for (const auto& [count, faces_and_nodes] : expected) {
    const Mesh body = cube(count);
    const Cut wanted = slit(body);
    const CutBody cut_body = cut("", body, CellComplex(body), wanted);
    BOOST_TEST(wanted.parted.size() == faces_and_nodes.first);
    BOOST_TEST(cut_body.mesh.nodes().size() ==
               body.nodes().size() + faces_and_nodes.second);
    BOOST_TEST(cut_body.mesh.region("slit-below").faces.size() == faces_and_nodes.first);
    BOOST_TEST(cut_body.mesh.region("slit-above").faces.size() == faces_and_nodes.first);
    BOOST_TEST(cut_body.mesh.boundary().faces.size() ==
               body.boundary().faces.size() + 2 * faces_and_nodes.first);
    BOOST_TEST(is_closed(cut_body.mesh.boundary().faces));
    BOOST_TEST(cut_body.mesh.volume() == body.volume());
  }
}

BOOST_AUTO_TEST_CASE(sides_of_a_slit_face_each_other) {
  const Mesh body = cube(10);
  const CutBody slit_body = cut("", body, CellComplex(body), slit(body));
  const Mesh& mesh = slit_body.mesh;
  const Region &below = mesh.region("slit-below"), &above = mesh.region("slit-above");
  for (const auto& [region, way] : {std::pair{&below, 1.}, {&above, -1.}})
    for (const FaceNodes& face : region->faces) {
      const auto x = [&](std::size_t i) { return mesh.nodes()[face[i]]; };
      const Vector3 normal = (x(2) - x(0)).cross(x(3) - x(1));
      BOOST_TEST(way * normal.z() > 0);
      BOOST_TEST(x(0).z() == 0.025);
    }
  std::size_t shared = 0;  // at the tip alone
  for (const NodeIndex node : below.nodes)
    shared += static_cast<std::size_t>(std::ranges::count(above.nodes, node));
  BOOST_TEST(shared == 11);
}

BOOST_AUTO_TEST_CASE(nodes_and_cells_keep_their_order_and_know_their_origin) {
  const Mesh body = cube(10);
  const CutBody slit_body = cut("", body, CellComplex(body), slit(body));
  for (NodeIndex n = 0; n < body.nodes().size(); ++n) {
    BOOST_TEST_REQUIRE(slit_body.node_origin[n] == n);
    BOOST_TEST_REQUIRE(slit_body.mesh.nodes()[n] == body.nodes()[n]);
  }
  for (std::size_t n = body.nodes().size(); n < slit_body.mesh.nodes().size(); ++n)
    BOOST_TEST_REQUIRE(slit_body.mesh.nodes()[n] ==
                       body.nodes()[slit_body.node_origin[n]]);

  const Cut hole = cavity(body);
  const CutBody hollow = cut("", body, CellComplex(body), hole);
  BOOST_TEST(hollow.mesh.cells().size() == 1000 - 64);
  BOOST_TEST(hollow.mesh.nodes().size() == body.nodes().size() - 27);
  BOOST_TEST(std::ranges::is_sorted(hollow.cell_origin));
  BOOST_TEST(std::ranges::is_sorted(hollow.node_origin));
  for (std::uint32_t c = 0; c < hollow.mesh.cells().size(); ++c)
    BOOST_TEST_REQUIRE(
        (centre(hollow.mesh, c) - centre(body, hollow.cell_origin[c])).norm() == 0);
}

BOOST_AUTO_TEST_CASE(cavity_has_a_surface_of_its_own) {
  const Mesh body = cube(10);
  const Mesh hollow = cut("", body, CellComplex(body), cavity(body)).mesh;
  BOOST_TEST(hollow.region("cavity").faces.size() == 6 * 16);
  BOOST_TEST(hollow.volume() == 0.05 * 0.05 * 0.05 - 0.02 * 0.02 * 0.02,
             boost::test_tools::tolerance(1e-13));
  // Nothing is in one place twice, so a file of it is read like any other.
  BOOST_CHECK_NO_THROW(check_conformity(hollow));
}

BOOST_AUTO_TEST_CASE(regions_lose_faces_of_removed_cells) {
  const Mesh body = generate_block({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  const Mesh left =
      cut("", body, CellComplex(body), {.name = "half", .removed = {0}}).mesh;
  BOOST_TEST(left.region("top").faces.size() == 1);
  BOOST_TEST(left.region("half").faces.size() == 1);
  BOOST_TEST(left.regions().count("x_min") == 0);
  BOOST_TEST(left.region("x_max").faces.size() == 1);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_cut_is_refused) {
  const Mesh body = generate_block({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  const CellComplex cells(body);
  std::uint8_t inner = 0;
  while (cells.across({0, inner}) != 1) ++inner;
  const std::uint8_t outer = inner == 0 ? 1 : 0;
  const std::string start = "here: cut 'c': expected ";
  const auto name = [](std::uint8_t face) {
    return "face " + std::to_string(face + 1) + " of cell 1";
  };
  check_refusal(
      body, {.name = "c", .parted = {{0, outer}}},
      start + "a face between two cells, got " + name(outer) + ", which has one");
  check_refusal(body, {.name = "c", .parted = {{0, inner}, cells.other_side({0, inner})}},
                start + "each face once, got " + name(inner) + " twice");
  check_refusal(body, {.name = "c", .parted = {{2, 0}}},
                start + "a face of the body, got face 1 of cell 3");
  check_refusal(body, {.name = "c", .removed = {0, 0}},
                start + "each cell once, got cell 1 twice");
  check_refusal(body, {.name = "c", .removed = {2}}, start + "cells up to 2, got cell 3");
  check_refusal(body, {.name = "c", .removed = {1, 0}},
                start + "at least one cell that stays, got none");
  check_refusal(body, {.name = "top", .removed = {0}},
                "here: cut 'top': expected a name of its own for each "
                "surface, got a second one of 'top'");
}

// The nodes of a face inside stay joined around it: one alone is no cut, and one that
// sticks out of a larger cut stays closed.
BOOST_AUTO_TEST_CASE(faces_past_which_all_nodes_hang_together_stay_closed) {
  const Mesh body = cube(6);
  const CellComplex cells(body);
  Cut alone{.name = "c"}, spur{.name = "c"};
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f) {
      const std::uint32_t other = cells.across({c, f});
      if (other == CellComplex::none || centre(body, other).z() < 0.025 ||
          centre(body, c).z() > 0.025)
        continue;
      const Vector3 at = 6 / 0.05 * centre(body, c);  // in cells
      const bool is_middle = std::abs(at.y() - 2.5) < 0.1;
      if (is_middle && std::abs(at.x() - 2.5) < 0.1) alone.parted.push_back({c, f});
      // Three by three cells in a corner, and two of the next ones beside them.
      if ((at.x() < 3 && at.y() < 3) || (is_middle && at.x() < 5))
        spur.parted.push_back({c, f});
    }
  BOOST_TEST(alone.parted.size() == 1);
  check_refusal(
      body, alone,
      "here: cut 'c': expected a cut at least two faces wide, or to the surface, "
      "got 1 faces whose nodes all stay joined around its end");
  BOOST_TEST(spur.parted.size() == 9 + 2);
  const Mesh mesh = cut("", body, cells, spur).mesh;
  BOOST_TEST(mesh.region("c-below").faces.size() == 9);
  BOOST_TEST(mesh.region("c-above").faces.size() == 9);
  BOOST_TEST(mesh.nodes().size() == body.nodes().size() + 9);
}

// Mesh itself refuses unused nodes, cells inside out and faces that do not fit.
BOOST_AUTO_TEST_CASE(thousand_random_cuts_leave_sound_bodies_or_are_refused) {
  std::size_t done = 0, refused = 0;
  for (unsigned seed = 1; done + refused < 1000; ++seed) {
    Mesh body = random_body(seed);
    std::mt19937 random(seed);
    for (int i = 0; i < 12; ++i) {
      Cut wanted = random_cut(CellComplex(body), random);
      wanted.name = "cut " + std::to_string(i);
      double removed = 0;
      for (const std::uint32_t c : wanted.removed) removed += body.cell_volumes()[c];
      try {
        const CutBody after = cut("", body, CellComplex(body), wanted);
        BOOST_TEST_REQUIRE(is_closed(after.mesh.boundary().faces));
        BOOST_TEST_REQUIRE(std::abs(after.mesh.volume() + removed - body.volume()) <
                           1e-13 * body.volume());
        for (NodeIndex n = 0; n < after.mesh.nodes().size(); ++n)
          BOOST_TEST_REQUIRE(
              (after.mesh.nodes()[n] == body.nodes()[after.node_origin[n]]));
        body = after.mesh;
        ++done;
      } catch (const InputError& error) {
        BOOST_TEST_REQUIRE(std::string_view(error.what()).find(": cut 'cut ") !=
                           std::string_view::npos);
        ++refused;
      }
      if (body.cells().size() == 1) break;
    }
  }
  BOOST_TEST(done > 800);
  BOOST_TEST(refused > 10);
}

BOOST_AUTO_TEST_SUITE_END()
