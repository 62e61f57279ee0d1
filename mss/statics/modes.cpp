#include "mss/statics/modes.hpp"

#include "mss/forces/tangent.hpp"
#include "statics/systems/free_triangle.hpp"

namespace springcheck::mss {

std::optional<NaturalModes> rest_modes(const Network& network,
                                       const std::vector<bool>& is_free, int count) {
  const statics::Unknowns unknowns(is_free);
  const Tangent tangent = tangent_at(network, network.rest_positions);
  statics::BlockMatrix stiffness(patches(network), network.masses.size());
  stiffness.assemble([&](std::size_t patch) { return part(tangent, patch); });
  Eigen::VectorXd masses(3 * std::ssize(network.masses));
  for (std::size_t n = 0; n < network.masses.size(); ++n)
    masses.segment<3>(static_cast<Eigen::Index>(3 * n)).setConstant(network.masses[n]);
  masses = unknowns.in(masses);

  auto modes =
      natural_modes(statics::FreeTriangle(stiffness, unknowns).copy_of(stiffness),
                    Eigen::SparseMatrix<double>(masses.asDiagonal()), count);
  if (!modes) return std::nullopt;
  Eigen::MatrixXd of_all = Eigen::MatrixXd::Zero(
      static_cast<Eigen::Index>(is_free.size()), modes->shapes.cols());
  of_all(unknowns.components(), Eigen::all) = modes->shapes;
  modes->shapes = std::move(of_all);
  return modes;
}

}  // namespace springcheck::mss
