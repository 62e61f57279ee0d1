#include <boost/test/unit_test.hpp>
#include <functional>

#include "meshing/generators/generate_block.hpp"
#include "mss/forces/forces.hpp"
#include "tests/dynamics/blocks/shuffled_cells.hpp"
#include "tests/mss/spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::even;
using dynamics::graded;
using dynamics::InstructionSet;
using dynamics::Precision;
using dynamics::shuffled_cells;

BOOST_AUTO_TEST_SUITE(kernels_test)

namespace {

constexpr double h = 0.005;  // m, the cells' edge

/// The strain measures that have kernels.
constexpr StrainMeasure measures[] = {StrainMeasure::engineering, StrainMeasure::green};

/// What errors are measured by: of springs of constant rest length the largest k L, of
/// mss-affine's the largest force.
double scale_of(const Network& network, const std::vector<Vector3>& forces) {
  double scale = 0;
  for (const Spring& spring : network.springs)
    scale = std::max(scale, spring.stiffness * spring.rest_length);
  if (scale > 0) return scale;
  for (const Vector3& force : forces) scale = std::max(scale, force.norm());
  return scale;
}

/// Displacements of up to a tenth of a cell, and velocities.
dynamics::State random_state(std::size_t nodes) {
  return {.displacements = random_field(nodes, 0.1 * h, 1),
          .velocities = random_field(nodes, 0.01, 2)};
}

using Oracle = std::function<std::vector<Vector3>(const std::vector<Vector3>& positions)>;

/// Largest difference between the kernel's force on a node and the oracle's, over the
/// scale.
double difference(const Mesh& mesh, const Network& network, const Oracle& oracle,
                  dynamics::State state, DynamicsSettings settings, InstructionSet set) {
  settings.kernel = Kernel::fast;
  if (settings.precision == Precision::single_precision)
    for (auto* field : {&state.displacements, &state.velocities})
      for (Vector3& v : *field) v = v.cast<float>().cast<double>();
  const std::vector<Vector3> x = sum(mesh.nodes(), state.displacements);
  std::vector<Vector3> expected = oracle(x);
  if (settings.damping_ratio > 0)
    add_dashpot_forces(network, settings.damping_ratio, x, state.velocities, expected);
  const auto found =
      motion_of(mesh, in_free_space(tissue_of(.25)), network, settings, set)
          ->forces_at(state);
  double largest = 0;
  for (std::size_t n = 0; n < x.size(); ++n)
    largest = std::max(largest, (found[n] - expected[n]).norm());
  return largest / scale_of(network, expected);
}

struct Bounds {
  double in_double = 1e-13, in_float = 2e-6;
};

/// The bounds, a few units of rounding. On the scale of k L of mss-cf and mss-nfd
/// they hold up to nu = .49, where kappa = 50 mu: from there on the rounding of F,
/// magnified by kappa/mu, is the larger part (measured at .499: 4.2e-13 and 1.6e-5).
Bounds bounds_of(double nu) {
  constexpr double at_49 = 50;
  const double kappa_over_mu = 2 * nu / (1 - 2 * nu);
  const double magnified = std::max(1., kappa_over_mu / at_49);
  return {.in_double = magnified * 1e-13, .in_float = magnified * 2e-6};
}

/// Checks the kernels in both precisions, by every instruction set, with and without
/// dashpots.
void check_kernels(const Mesh& mesh, const Network& network, const Oracle& oracle,
                   const dynamics::State& state, const Bounds& bounds) {
  for (const InstructionSet set : dynamics::all_instruction_sets) {
    if (!dynamics::is_available(set)) continue;
    for (const double zeta : {0., .3})
      for (const Precision precision :
           {Precision::double_precision, Precision::single_precision})
        BOOST_TEST_CONTEXT(dynamics::name_of(set) << ", zeta " << zeta) {
          DynamicsSettings settings = settings_of(
              dynamics::Integrator::semi_implicit_euler, 1, std::nullopt, zeta);
          settings.precision = precision;
          // Single precision is refused where there is no kernel.
          BOOST_TEST_REQUIRE(!reason_to_refuse(mesh, network, settings));
          BOOST_TEST(difference(mesh, network, oracle, state, settings, set) <
                     (precision == Precision::double_precision ? bounds.in_double
                                                               : bounds.in_float));
        }
  }
}

void check_kernels(const Mesh& mesh, const Network& network, const Bounds& bounds) {
  const auto oracle = [&](const std::vector<Vector3>& x) {
    std::vector<Vector3> forces(x.size());
    nodal_forces(network, x, forces);
    return forces;
  };
  check_kernels(mesh, network, oracle, random_state(mesh.nodes().size()), bounds);
}

struct NamedMesh {
  const char* name;
  Mesh mesh;
};

/// The mesh turned about an axis that is none of its own.
Mesh turned(const Mesh& mesh) {
  const Matrix3 turn =
      Eigen::AngleAxisd(.7, Vector3(1, 2, 2).normalized()).toRotationMatrix();
  std::vector<Vector3> nodes;
  for (const Vector3& x : mesh.nodes()) nodes.emplace_back(turn * x);
  return Mesh("turned", std::move(nodes), mesh.cells(), {});
}

/// A regular cube, loose random cells, and boxes of all sizes.
std::vector<NamedMesh> meshes_of_boxes() {
  return {
      {"cube", cube(10, h)},
      {"random cells", shuffled_cells({even(13, h), even(12, h), even(11, h)}, .6, 1)},
      {"plate", shuffled_cells({even(21, h), even(2, h), even(1, h)}, .9, 2)},
      {"boxes", shuffled_cells({graded(9, h), even(10, h), graded(12, h)}, .8, 3)},
      {"turned cube", turned(cube(6, h))}};
}

Mesh block_of(CellPattern pattern, int cells, double distortion) {
  return generate_block({.size = {cells * h, cells * h, cells * h},
                         .cells = {cells, cells, cells},
                         .pattern = pattern,
                         .distortion = distortion});
}

Mesh moved(const Mesh& mesh, const Vector3& way) {
  std::vector<Vector3> nodes;
  for (const Vector3& x : mesh.nodes()) nodes.emplace_back(x + way);
  return Mesh("moved", std::move(nodes), mesh.cells(), {});
}

Mesh turned_and_sheared(const Mesh& mesh) {
  Eigen::Matrix3d map;
  map << .8, -.5, .1, .3, 1.1, -.2, .2, .1, .9;
  std::vector<Vector3> nodes;
  for (const Vector3& x : mesh.nodes()) nodes.emplace_back(map * x);
  return Mesh("sheared", std::move(nodes), mesh.cells(), {});
}

/// Meshes of cells in a grid or not, of any shape.
std::vector<NamedMesh> meshes_of_hexahedra() {
  return {{"distorted cube", block_of(CellPattern::hexahedron, 10, .2)},
          {"free hexahedra", block_of(CellPattern::free_hexahedron, 4, 0)},
          {"parallelepipeds", turned_and_sheared(shuffled_cells(
                                  {even(9, h), even(8, h), even(7, h)}, .6, 1))}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(kernels_equal_the_plain_loops_on_boxes) {
  for (const auto& [mesh_name, mesh] : meshes_of_boxes())
    for (const auto& [model_name, model] : models_on_cubes)
      for (const StrainMeasure measure : measures)
        for (const double nu : {0., .25, .45, .49, .499}) {
          if (reason_to_refuse(mesh, tissue_of(nu), model)) continue;
          BOOST_TEST_CONTEXT(mesh_name << ", " << model_name << ", strain measure "
                                       << static_cast<int>(measure) << ", nu " << nu)
          check_kernels(mesh,
                        build_network(mesh, tissue_of(nu), springs_in(measure, model)),
                        model == SpringModel::affine ? Bounds{} : bounds_of(nu));
        }
}

// Engineering strains along 6 and 16 axes; in squared lengths all are one law, and have
// one kernel.
BOOST_AUTO_TEST_CASE(the_affine_kernel_knows_its_axes) {
  for (const StrainMeasure measure : {StrainMeasure::engineering, StrainMeasure::green})
    for (const Axes axes : {Axes::six, Axes::sixteen}) {
      NetworkSettings settings = springs_in(measure, SpringModel::affine);
      settings.axes = axes;
      const Mesh mesh = block_of(CellPattern::hexahedron, 6, .2);
      check_kernels(mesh, build_network(mesh, tissue_of(.4), settings), Bounds{});
    }
}

// On the scale of its largest force mss-affine keeps the bounds up to nu = .4999: the
// rounding of F and the force both go with kappa.
BOOST_AUTO_TEST_CASE(the_affine_kernel_equals_the_plain_loops_on_any_hexahedra) {
  for (const auto& [name, mesh] : meshes_of_hexahedra())
    for (const StrainMeasure measure : measures)
      for (const double nu : {-.5, .25, .45, .49, .499, .4999}) {
        BOOST_TEST_CONTEXT(name << ", strain measure " << static_cast<int>(measure)
                                << ", nu " << nu)
        check_kernels(
            mesh,
            build_network(mesh, tissue_of(nu), springs_in(measure, SpringModel::affine)),
            Bounds{});
      }
}

// A metre away positions are rounded to 1e-16 m, 2e-14 of a cell's edge, by the oracle
// too: some twenty springs of a node, both ends of each.
BOOST_AUTO_TEST_CASE(kernels_are_as_good_away_from_the_origin) {
  const Mesh away = moved(meshes_of_boxes().back().mesh, {1, -1, 1});
  for (const SpringModel model : {SpringModel::cf, SpringModel::affine})
    for (const StrainMeasure measure : measures) {
      if (reason_to_refuse(away, tissue_of(.4), model)) continue;
      BOOST_TEST_CONTEXT(static_cast<int>(model))
      check_kernels(away, build_network(away, tissue_of(.4), springs_in(measure, model)),
                    {.in_double = 1e-12});
    }
}

// A spring of no length pulls nowhere, and has no axis for its dashpot: the ends of an
// edge, of a face diagonal and of an inner diagonal in one place, exactly so in both
// precisions where edges are a power of two. What the spring does to the cell's F stays,
// and the oracle leaves the whole spring out: expected is the mean of what it gives to
// either side, 3e-14 of an edge away.
BOOST_AUTO_TEST_CASE(nodes_in_one_place_pull_each_other_nowhere) {
  constexpr double edge = 1. / 256;
  const Mesh mesh = cube(4, edge);
  const auto node_at = [&](const Vector3& point) {
    return static_cast<std::size_t>(std::ranges::find(mesh.nodes(), point) -
                                    mesh.nodes().begin());
  };
  const std::size_t centre = node_at(edge * Vector3(2, 2, 2));
  BOOST_TEST_REQUIRE(centre < mesh.nodes().size());
  for (const auto& [model_name, model] : models_on_cubes)
    for (const Vector3& step : {Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(1, 1, 1)}) {
      dynamics::State state{
          .displacements = std::vector<Vector3>(mesh.nodes().size(), Vector3::Zero()),
          .velocities = random_field(mesh.nodes().size(), 0.01, 2)};
      state.displacements[centre] = edge * step;
      const Network network =
          build_network(mesh, tissue_of(.25), in_shear_modulus_form(model));
      const auto oracle = [&](std::vector<Vector3> x) {
        const Vector3 aside = edge * 0x1p-45 * Vector3::Ones();
        std::vector<Vector3> here(x.size()), there(x.size());
        x[centre] += aside;
        nodal_forces(network, x, here);
        x[centre] -= 2 * aside;
        nodal_forces(network, x, there);
        for (std::size_t n = 0; n < x.size(); ++n) here[n] = (here[n] + there[n]) / 2;
        return here;
      };
      BOOST_TEST_CONTEXT(model_name << ", step " << step.transpose())
      check_kernels(mesh, network, oracle, state, {});
    }
}

BOOST_AUTO_TEST_SUITE_END()
