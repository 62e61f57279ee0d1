#include "fem_reference/solve.hpp"

#include <fmt/format.h>

#include "fem_reference/equilibrium.hpp"
#include "meshing/input_error.hpp"

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
  if (scene.plates.empty()) throw InputError("scene", "plates", "at least 1", "0");
}

std::vector<Vector3> by_node(const Eigen::VectorXd& nodal) {
  std::vector<Vector3> vectors;
  for (Eigen::Index dof = 0; dof < nodal.size(); dof += 3)
    vectors.emplace_back(nodal.segment<3>(dof));
  return vectors;
}

}  // namespace

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings) {
  check(scene);
  const std::vector<PrescribedNode> prescribed = prescribed_nodes(mesh, scene);
  std::vector<NodeIndex> nodes;
  for (const auto& [node, plate] : prescribed) nodes.push_back(node);
  Elasticity body(mesh, scene.material, settings, nodes);

  const auto plate_displacements = [&](double load_fraction) {
    Eigen::VectorXd nodal =
        Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.nodes().size()));
    for (const auto& [node, plate] : prescribed)
      nodal.segment<3>(3 * node) =
          displacement(scene.plates[plate].motion, mesh.nodes()[node], load_fraction);
    return nodal;
  };
  const Equilibrium found = find_equilibrium(
      body, settings.law,
      {.displacements = plate_displacements, .forces = body.weight(scene.gravity)});

  return {.status = found.status,
          .reason = found.reason,
          .displacements = by_node(found.displacements),
          .reactions = by_node(found.reactions),
          .lever_arms =
              settings.law == Law::hooke ? LeverArms::undeformed : LeverArms::deformed,
          .strain_energy = found.energy,
          .load_fraction = found.load_fraction,
          .steps = found.steps,
          .force_evaluations = found.force_evaluations};
}

}  // namespace springcheck::fem_reference
