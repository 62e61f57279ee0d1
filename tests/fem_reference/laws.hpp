#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fem_reference/laws/materials.hpp"

// What several tests of the laws are made from.
namespace springcheck::fem_reference {

inline constexpr double young = 1e4;  // Pa

inline Material of_poisson_ratio(double nu) {
  return {.young_modulus = young, .poisson_ratio = nu, .density = 1000};
}

struct NamedLaw {
  std::string name;
  Material material;
  Settings settings;
  Constitution law;
};

inline NamedLaw named(const std::string& name, double nu, const Settings& settings) {
  const Material material = of_poisson_ratio(nu);
  return {.name = name + ", nu " + std::to_string(nu),
          .material = material,
          .settings = settings,
          .law = constitution(material, settings)};
}

/// Hooke, St-Venant-Kirchhoff, Hencky, and the continua of all lattices with their
/// diagonal ratios and directions; of two also in other strains, and along 16 and 25
/// axes.
inline std::vector<NamedLaw> laws_at(double nu) {
  std::vector<NamedLaw> all{
      named("hooke", nu, {.law = Law::hooke, .element = Element::q1}),
      named("st-venant", nu, {.law = Law::st_venant_kirchhoff, .element = Element::q1}),
      named("hencky", nu, {.law = Law::hencky, .element = Element::q1})};
  struct {
    const char* name;
    Springs springs;
    std::vector<double> ratios;  // A
  } const lattices[]{{"baudet", Springs::baudet, {1}},
                     {"nfd", Springs::nfd, {1}},
                     {"fd", Springs::fd, {1}},
                     {"cf", Springs::cf, {0.1, 1, 10}},
                     {"affine", Springs::affine, {1}}};
  for (const auto& [name, springs, ratios] : lattices) {
    if (springs == Springs::baudet && nu <= -0.25) continue;
    for (const double ratio : ratios)
      for (const LatticeDirection direction :
           {LatticeDirection::d100, LatticeDirection::d110, LatticeDirection::d111})
        all.push_back(named(
            "cauchy-born " + std::string(name) + ", A " + std::to_string(ratio) +
                ", direction " + std::to_string(static_cast<int>(direction)),
            nu,
            {.law = Law::cauchy_born,
             .element = Element::q1,
             .lattice = {
                 .springs = springs, .diagonal_ratio = ratio, .direction = direction}}));
  }
  for (const Springs springs : {Springs::cf, Springs::affine})
    for (const SpringStrain strain :
         {SpringStrain::green, SpringStrain::logarithmic, SpringStrain::hencky})
      for (const int axes : {6, 16, 25}) {
        if (axes != 6 && springs == Springs::cf) continue;
        all.push_back(named("cauchy-born " + std::to_string(static_cast<int>(springs)) +
                                ", strain " + std::to_string(static_cast<int>(strain)) +
                                ", axes " + std::to_string(axes),
                            nu,
                            {.law = Law::cauchy_born,
                             .element = Element::q1,
                             .lattice = {.springs = springs,
                                         .direction = LatticeDirection::d110,
                                         .strain = strain,
                                         .axes = axes}}));
      }
  return all;
}

inline constexpr double poisson_ratios[] = {-0.3, 0, 0.25, 0.45, 0.499};

inline std::vector<NamedLaw> all_laws() {
  std::vector<NamedLaw> all;
  for (const double nu : poisson_ratios)
    for (NamedLaw& law : laws_at(nu)) all.push_back(std::move(law));
  return all;
}

/// The largest modulus, to which rounding of stresses is relative [Pa].
inline double stiffness_scale(const Material& material) {
  const auto [lambda, mu] = lame_constants(material);
  return std::abs(lambda) + 2 * mu;
}

/// A displacement gradient with stretch, shear and rotation, all different.
inline Matrix3 general_gradient() {
  Matrix3 H;
  H << 0.11, -0.23, 0.07, 0.19, -0.16, 0.31, -0.05, 0.13, 0.22;
  return H;
}

inline Matrix3 diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}

inline Matrix3 rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The displacement gradient of the motion F and then the rotation Q.
inline Matrix3 turned(const Matrix3& Q, const Matrix3& H) {
  return Q * (Matrix3::Identity() + H) - Matrix3::Identity();
}

inline double largest(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

/// Derivative at 0 by central differences of step d and d/2, Richardson extrapolated:
///
///     f' = [4 D(d/2) - D(d)]/3 + O(d^4 f^(5)) + rounding/d
///
/// With d = 1e-3 both errors are near 1e-12 of a smooth f of size 1.
inline Eigen::VectorXd derivative(const std::function<Eigen::VectorXd(double)>& f,
                                  double d = 1e-3) {
  const Eigen::VectorXd wide = (f(d) - f(-d)) / (2 * d);
  const Eigen::VectorXd narrow = (f(d / 2) - f(-d / 2)) / d;
  return (4 * narrow - wide) / 3;
}

/// Derivative of a function of H by the nine entries of H, as columns.
inline Eigen::MatrixXd gradient(const std::function<Eigen::VectorXd(const Matrix3&)>& f,
                                const Matrix3& H) {
  Eigen::MatrixXd columns(f(H).size(), 9);
  for (int entry = 0; entry < 9; ++entry)
    columns.col(entry) = derivative([&](double d) {
      Matrix3 moved = H;
      moved.reshaped()[entry] += d;
      return f(moved);
    });
  return columns;
}

inline Eigen::VectorXd scalar(double value) {
  return Eigen::VectorXd::Constant(1, value);
}

/// dP/dF of the whole law, shape and volumetric part.
inline Matrix9 tangent(const Constitution& law, const Matrix3& H) {
  return std::visit(
      [&](const auto& part) -> Matrix9 {
        const Dilatation t = part.dilatation(H);
        const VolumetricEnergy U = part.volumetric_energy(t.value);
        return part.tangent(H) + U.first * t.second +
               U.second * t.first.reshaped() * t.first.reshaped().transpose();
      },
      law);
}

}  // namespace springcheck::fem_reference
