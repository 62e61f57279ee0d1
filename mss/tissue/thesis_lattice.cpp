#include "mss/tissue/thesis_lattice.hpp"

#include <Eigen/Core>
#include <array>
#include <span>

#include "tissue/checks.hpp"

namespace springcheck::mss {
namespace {

using Vector3 = Eigen::Vector3d;

/// T d_x d_z/|d| [N m] of all springs along the directions r/h.
double virial(const ThesisTissue& lattice, double stiffness,
              std::span<const Vector3> directions, double strain) {
  double sum = 0;
  for (const Vector3& direction : directions) {
    const Vector3 rest = lattice.cell_edge * direction;
    const Vector3 d = rest + Vector3(strain * rest.z(), 0, 0);
    const double length = d.norm();
    sum +=
        tension(lattice.spring, stiffness, rest.norm(), length) * d.x() * d.z() / length;
  }
  return sum;
}

}  // namespace

ThesisTissue thesis_tissue(const tissue::BipowerLaw& law, double hand_fitted_limit,
                           tissue::Elongation elongation, double cell_edge) {
  tissue::check(law);
  tissue::check_positive("edge of the cells [m]", cell_edge);
  constexpr double poisson_ratio = 0.499, diagonal_ratio = 1;
  const double shear_modulus = law.consistency / (2 * (1 + poisson_ratio));
  return {.spring = {law, hand_fitted_limit, elongation},
          .stiffness = shear_modulus_form(shear_modulus, cell_edge, diagonal_ratio),
          .cell_edge = cell_edge};
}

double shear_stress(const ThesisTissue& lattice, double strain) {
  const std::array<Vector3, 3> edges{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<Vector3, 6> face_diagonals{
      {{1, 1, 0}, {1, -1, 0}, {0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {1, 0, -1}}};
  const std::array<Vector3, 4> inner_diagonals{
      {{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
  const auto& [k_edge, k_face, k_inner] = lattice.stiffness;
  const double volume = lattice.cell_edge * lattice.cell_edge * lattice.cell_edge;
  return (virial(lattice, k_edge, edges, strain) +
          virial(lattice, k_face, face_diagonals, strain) +
          virial(lattice, k_inner, inner_diagonals, strain)) /
         volume;
}

}  // namespace springcheck::mss
