#include "statics/loading.hpp"

#include "meshing/loads/turn.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::statics {

Loading loading(const Mesh& mesh, const Scene& scene, Eigen::VectorXd forces) {
  const std::vector<PrescribedComponent> prescribed = prescribed_components(mesh, scene);
  const Eigen::Index components = forces.size();
  return {
      .is_free = free_components(mesh, prescribed),
      .displacements =
          [&mesh, &scene, prescribed, components](double load_fraction) {
            Eigen::VectorXd all = Eigen::VectorXd::Zero(components);
            for (const PrescribedComponent& held : prescribed)
              all[3 * Eigen::Index{held.node} + held.component] =
                  prescribed_displacement(mesh, scene, held, load_fraction);
            return all;
          },
      .forces = std::move(forces),
      .follows_supports =
          [&mesh, &scene](const Eigen::VectorXd& displacements, double load_fraction) {
            const Eigen::VectorXd positions = stacked(mesh.nodes()) + displacements;
            return shows_imposed_turn(mesh, scene, by_node(positions), load_fraction);
          }};
}

}  // namespace springcheck::statics
