#pragma once

#include <map>
#include <string>

#include "mss/tissue/tissue_body.hpp"
#include "tests/mss/blocks.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck::mss {

inline constexpr double h = 0.005;       // [m]
inline constexpr double density = 1000;  // [kg/m^3]

/// The solid with the branches fitted to an organ's law.
inline const tissue::Solid& solid_of(const std::string& organ, double nu = 0.499) {
  static std::map<std::pair<std::string, double>, tissue::Solid> solids;
  auto& solid = solids[{organ, nu}];
  if (solid.shear.branches.empty())
    solid = {tissue::fit_maxwell_model(tissue::law_of_organ(organ)).model,
             tissue::bulk_ratio_of(nu)};
  return solid;
}

// The law of tissue replaces Hooke's; the density is read, and nu by solve_tissue.
inline constexpr Material any_material{
    .young_modulus = 1, .poisson_ratio = 0.499, .density = density};

/// The whole boundary follows x -> x + gamma z.
inline Scene in_simple_shear(double strain) {
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  gradient(0, 2) = strain;
  return {.material = any_material,
          .plates = {},
          .boundary_gradient = gradient,
          .gravity = Vector3::Zero()};
}

inline Scene between_glued_plates(const Vector3& way) {
  return {.material = any_material,
          .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                     {"top", translation(way), all_components}},
          .gravity = Vector3::Zero()};
}

/// Mean of sigma_xz = P_xz in simple shear: reactions times rest positions, over V.
inline double mean_shear_stress(const Mesh& mesh, const std::vector<Vector3>& reactions) {
  double sum = 0;
  for (std::size_t n = 0; n < reactions.size(); ++n)
    sum += reactions[n].x() * mesh.nodes()[n].z();
  return sum / mesh.volume();
}

}  // namespace springcheck::mss
