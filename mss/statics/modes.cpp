#include "mss/statics/modes.hpp"

#include "mss/forces/assembly.hpp"

namespace springcheck::mss {

std::optional<NaturalModes> rest_modes(const Network& network,
                                       const std::vector<bool>& is_free, int count) {
  FreeAssembly assembly(network, is_free);
  std::vector<Eigen::Index> components;  // of the unknowns
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) components.push_back(static_cast<Eigen::Index>(i));
  Eigen::VectorXd masses(assembly.size());
  for (std::size_t u = 0; u < components.size(); ++u)
    masses[static_cast<Eigen::Index>(u)] =
        network.masses[static_cast<std::size_t>(components[u]) / 3];

  auto modes =
      natural_modes(assembly.assemble(tangent_at(network, network.rest_positions)),
                    Eigen::SparseMatrix<double>(masses.asDiagonal()), count);
  if (!modes) return std::nullopt;
  Eigen::MatrixXd of_all = Eigen::MatrixXd::Zero(
      static_cast<Eigen::Index>(is_free.size()), modes->shapes.cols());
  of_all(components, Eigen::all) = modes->shapes;
  modes->shapes = std::move(of_all);
  return modes;
}

}  // namespace springcheck::mss
