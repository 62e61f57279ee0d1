#include "mss/statics/static_solution.hpp"

#include "mss/forces/forces.hpp"

namespace springcheck::mss {

Solution static_solution(const Mesh& mesh, const Scene& scene, const Network& network,
                         std::span<const Vector3> positions, double load_fraction) {
  std::vector<Vector3> forces(positions.size());
  nodal_forces(network, positions, forces);
  const std::vector<Vector3> load = load_forces(mesh, scene, network);
  Solution solution{.status = SolveStatus::ok,
                    .reactions = std::vector<Vector3>(positions.size(), Vector3::Zero()),
                    .lever_arms = LeverArms::deformed,
                    .strain_energy = strain_energy(network, positions),
                    .load_fraction = load_fraction,
                    .steps = 0,
                    .force_evaluations = 0};
  for (std::size_t n = 0; n < positions.size(); ++n)
    solution.displacements.push_back(positions[n] - mesh.nodes()[n]);
  for (const auto& [node, i, plate] : prescribed_components(mesh, scene))
    solution.reactions[node][i] = -(forces[node][i] + load_fraction * load[node][i]);
  return solution;
}

}  // namespace springcheck::mss
