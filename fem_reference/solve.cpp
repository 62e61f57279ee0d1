#include "fem_reference/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "fem_reference/cells/discretisation.hpp"
#include "fem_reference/statics/coverage.hpp"
#include "fem_reference/statics/elements_body.hpp"
#include "fem_reference/statics/loads.hpp"
#include "fem_reference/statics/supports.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "meshing/loads/turn.hpp"
#include "statics/equilibrium.hpp"
#include "statics/last_stable_equilibrium.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::fem_reference {
namespace {

void check(const Scene& scene) {
  const auto& [E, nu, rho] = scene.material;
  if (!(E > 0))
    throw InputError("material", "young_modulus", "above 0 Pa", fmt::to_string(E));
  if (!(nu > -1 && nu < 0.5))
    throw InputError("material", "poisson_ratio", "in (-1, 0.5)", fmt::to_string(nu));
  if (!(rho > 0))
    throw InputError("material", "density", "above 0 kg/m^3", fmt::to_string(rho));
  if (scene.plates.empty() && !scene.boundary_gradient)
    throw InputError("scene", "plates", "at least 1, or a boundary gradient", "0");
}

/// External nodal forces at the full load [N].
Eigen::VectorXd load(const Discretisation& body, const Scene& scene) {
  const Vector3 weight = scene.material.density * scene.gravity;
  Eigen::VectorXd forces = body_load(body, [&](const Vector3&) { return weight; });
  for (const Traction& traction : scene.tractions)
    forces += traction_load(body, traction);
  return forces;
}

/// The mesh's cells, or the eight parts of each that q2's intermediate nodes make.
std::vector<CellNodes> finest_cells(const Mesh& mesh, const Discretisation& body) {
  if (body.parents.empty()) return mesh.cells();
  std::map<std::vector<NodeIndex>, NodeIndex> node_between;
  for (std::size_t i = 0; i < body.parents.size(); ++i)
    node_between[body.parents[i]] = static_cast<NodeIndex>(body.vertices + i);
  constexpr std::array<std::array<int, 3>, 8> place{{{0, 0, 0},
                                                     {1, 0, 0},
                                                     {1, 1, 0},
                                                     {0, 1, 0},
                                                     {0, 0, 1},
                                                     {1, 0, 1},
                                                     {1, 1, 1},
                                                     {0, 1, 1}}};  // of a corner
  std::vector<CellNodes> parts;
  for (const CellNodes& cell : mesh.cells())
    for (const auto& of_part : place) {
      CellNodes part;
      for (const auto& corner : place) {
        // The part's corner lies between all corners of the cell that agree with it in
        // each direction in which it is at an end.
        std::vector<NodeIndex> between;
        for (std::size_t i = 0; i < place.size(); ++i) {
          bool agrees = true;
          for (std::size_t k = 0; k < 3; ++k)
            agrees = agrees && (of_part[k] != corner[k] || place[i][k] == corner[k]);
          if (agrees) between.push_back(cell[i]);
        }
        std::ranges::sort(between);
        part.push_back(between.size() == 1 ? between.front() : node_between.at(between));
      }
      parts.push_back(part);
    }
  return parts;
}

}  // namespace

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const statics::Search& search) {
  check(scene);
  if (const auto reason = reason_to_refuse(mesh, scene, settings))
    return refused(*reason);
  const Stopwatch setup;
  const Discretisation body = discretise(mesh, settings.element);
  const Supports supports(mesh, scene, body);
  ElementsBody elements(body, {.constitution = constitution(scene.material, settings),
                               .dilatation = dilatation_taken(settings)});
  // Hooke's law has one solution for each place of the supports, whichever way they
  // turned to it.
  const bool turns = turns_far(scene) && !elements.is_linear();
  const std::vector<CellNodes> finest =
      turns || search.to_limit ? finest_cells(mesh, body) : std::vector<CellNodes>{};
  const statics::Loading loading{
      .is_free = supports.is_free(),
      .displacements = [&](double s) { return supports.displacements(s); },
      .forces = load(body, scene),
      .follows_supports =
          [&](const Eigen::VectorXd& displacements, double s) {
            const Eigen::VectorXd positions =
                statics::stacked(body.nodes) + displacements;
            return !turns || shows_imposed_turn(mesh, scene, {finest, body.nodes},
                                                statics::by_node(positions), s);
          }};
  const statics::Equilibrium found =
      search.to_limit
          ? statics::last_stable_equilibrium(elements, loading, {mesh.cells(), finest},
                                             search.linear_solver, setup)
          : statics::find_equilibrium(elements, loading, search, setup);

  Solution solution = statics::solution_of(found);
  solution.displacements.resize(mesh.nodes().size());  // q2 has more
  solution.reactions = on_vertices(body, found.reactions);
  if (settings.law == Law::hooke) solution.lever_arms = LeverArms::undeformed;
  if (settings.element == Element::q2) {
    solution.cell_volumes = elements.cell_volumes(found.displacements);
    for (const Traction& traction : scene.tractions)
      solution.loaded_face_displacements.push_back(
          mean_displacement(body, traction.region, found.displacements));
  }
  return solution;
}

}  // namespace springcheck::fem_reference
