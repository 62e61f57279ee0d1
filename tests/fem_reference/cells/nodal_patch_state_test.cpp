#include "fem_reference/cells/nodal_patch_state.hpp"

#include <boost/test/unit_test.hpp>

#include "fem_reference/statics/elements_body.hpp"
#include "meshing/cell_geometry.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// q1_nodal: what its energy is a sum of. Derivatives and equilibria of it are tested with
// the other elements'.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(nodal_patch_state_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

const Material material = of_poisson_ratio(0.3);

CellLaw law_of(Law law, Element element) {
  const Settings settings{.law = law, .element = element};
  return {.constitution = constitution(material, settings),
          .dilatation = dilatation_taken(settings)};
}

double energy_of(const Mesh& mesh, Law law, Element element, const Eigen::VectorXd& u) {
  const Discretisation body = discretise(mesh, element);
  ElementsBody elements(body, law_of(law, element));
  return elements.state(u).strain_energy;
}

/// H of a tetrahedron from its edges, without shape functions.
Matrix3 gradient_of(const Mesh& mesh, const CellNodes& cell, const Eigen::VectorXd& u) {
  Matrix3 rest, moved;
  for (int k = 0; k < 3; ++k) {
    const NodeIndex a = cell[0], b = cell[static_cast<std::size_t>(k + 1)];
    rest.col(k) = mesh.nodes()[b] - mesh.nodes()[a];
    moved.col(k) = rest.col(k) + u.segment<3>(3 * b) - u.segment<3>(3 * a);
  }
  return moved * rest.inverse() - Matrix3::Identity();
}

/// The quarters of a node's tetrahedra.
struct Quarters {
  double volume = 0;
  Matrix3 gradient = Matrix3::Zero();  // times the volume
};

/// W of the header, node by node.
double energy_around_nodes(const Mesh& mesh, Law law, const Eigen::VectorXd& u) {
  return std::visit(
      [&](const auto& part) {
        std::vector<Quarters> around(mesh.nodes().size());
        double energy = 0;
        for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
          const double volume = mesh.cell_volumes()[c];
          const Matrix3 H = gradient_of(mesh, mesh.cells()[c], u);
          energy += tetrahedron_part * volume * part.energy(H);
          for (const NodeIndex node : mesh.cells()[c]) {
            around[node].volume += volume / 4;
            around[node].gradient += volume / 4 * H;
          }
        }
        for (const auto& [volume, gradient] : around) {
          const Matrix3 H = gradient / volume;
          energy += volume * ((1 - tetrahedron_part) * part.energy(H) +
                              part.volumetric_energy(part.dilatation(H).value).value);
        }
        return energy;
      },
      constitution(material, {.law = law, .element = Element::q1_nodal}));
}

}  // namespace

BOOST_AUTO_TEST_CASE(tetrahedra_have_the_energy_of_their_nodes) {
  const Mesh mesh = warped_cube(2, CellPattern::tetrahedron);
  const Discretisation body = discretise(mesh, Element::q1_nodal);
  const Eigen::VectorXd u = random_nodal(body, 0.02 * edge);
  for (const Law law : laws)
    BOOST_TEST(
        energy_of(mesh, law, Element::q1_nodal, u) == energy_around_nodes(mesh, law, u),
        round_off);
}

// All means are the cell's own there.
BOOST_AUTO_TEST_CASE(a_tetrahedron_alone_is_the_linear_element) {
  const Mesh mesh{"one cell",
                  {edge * Vector3(0, 0, 0), edge * Vector3(1, 0.1, 0),
                   edge * Vector3(0.5, 0.9, 0.1), edge * Vector3(0.4, 0.3, 0.8)},
                  {CellNodes{0, 1, 2, 3}},
                  {}};
  const Discretisation body = discretise(mesh, Element::q1_nodal);
  const Eigen::VectorXd u = random_nodal(body, 0.1 * edge);
  for (const Law law : laws)
    BOOST_TEST(energy_of(mesh, law, Element::q1_nodal, u) ==
                   energy_of(mesh, law, Element::q1, u),
               round_off);
}

// One cell that is no tetrahedron is the element q1_sri, whose mean dilatation is the
// cell's.
BOOST_AUTO_TEST_CASE(another_cell_alone_has_its_mean_dilatation) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::prism}) {
    const Mesh block = warped_cube(1, pattern);
    CellNodes nodes;
    std::vector<Vector3> places;
    for (const NodeIndex node : block.cells().front()) {
      nodes.push_back(static_cast<NodeIndex>(places.size()));
      places.push_back(block.nodes()[node]);
    }
    const Mesh mesh{"one cell", places, {nodes}, {}};
    const Discretisation body = discretise(mesh, Element::q1_nodal);
    const Eigen::VectorXd u = random_nodal(body, 0.1 * edge);
    for (const Law law : {Law::hooke, Law::st_venant_kirchhoff, Law::hencky})
      BOOST_TEST(energy_of(mesh, law, Element::q1_nodal, u) ==
                     energy_of(mesh, law, Element::q1_sri, u),
                 round_off);
  }
}

// V_n (1 + t_n), t = det F - 1, is the deformed nodal patch's volume, of hexahedra and
// prisms.
BOOST_AUTO_TEST_CASE(mean_dilatations_are_the_patches_change_of_volume) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::prism}) {
    const Mesh mesh = warped_cube(2, pattern);
    const Discretisation body = discretise(mesh, Element::q1_nodal);
    const Eigen::VectorXd u = random_nodal(body, 0.05 * edge);
    std::vector<Vector3> moved = mesh.nodes();
    for (std::size_t n = 0; n < moved.size(); ++n)
      moved[n] += u.segment<3>(static_cast<Eigen::Index>(3 * n));
    const std::vector<double> volumes = cell_volumes(mesh.cells(), moved);
    std::vector<double> of_patches(mesh.nodes().size(), 0);
    for (std::size_t c = 0; c < volumes.size(); ++c)
      for (const NodeIndex node : mesh.cells()[c])
        of_patches[node] += volumes[c] / static_cast<double>(mesh.cells()[c].size());
    const NodalPatchState state =
        nodal_patch_state(law_of(Law::hencky, Element::q1_nodal), body, u);
    for (std::size_t n = 0; n < of_patches.size(); ++n)
      BOOST_TEST(
          body.nodal_patches.volumes[n] * (1 + state.dilatations[n]) == of_patches[n],
          round_off);
  }
}

BOOST_AUTO_TEST_CASE(a_patch_that_is_inside_out_has_no_energy) {
  const Mesh mesh = cube(1, CellPattern::tetrahedron);
  const Discretisation body = discretise(mesh, Element::q1_nodal);
  const Eigen::VectorXd u = nodal(body, [&](const Vector3& X) -> Vector3 {
    return {0, 0, -2.5 * X.z()};
  });
  BOOST_TEST(nodal_patch_state(law_of(Law::hencky, Element::q1_nodal), body, u).energy ==
             INFINITY);
  BOOST_TEST(std::isfinite(
      nodal_patch_state(law_of(Law::hooke, Element::q1_nodal), body, u).energy));
}

BOOST_AUTO_TEST_SUITE_END()
