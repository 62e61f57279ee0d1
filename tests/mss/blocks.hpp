#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>

#include "meshing/generators/generate_block.hpp"
#include "meshing/loads/scene.hpp"
#include "mss/networks/network.hpp"

// What several tests of the mass-spring systems are made from.
namespace springcheck::mss {

/// n x n x n cells of edge h [m].
inline Mesh cube(int n, double h) {
  return generate_block({.size = {n * h, n * h, n * h}, .cells = {n, n, n}});
}

inline NetworkSettings in_shear_modulus_form(SpringModel model) {
  return {.model = model,
          .stiffness_form = StiffnessForm::shear_modulus,
          .diagonal_ratio = 1};
}

inline constexpr StrainMeasure all_measures[] = {
    StrainMeasure::engineering, StrainMeasure::green, StrainMeasure::logarithmic,
    StrainMeasure::hencky};

inline constexpr Axes all_axes[] = {Axes::six, Axes::sixteen, Axes::twenty_five};

inline NetworkSettings springs_in(StrainMeasure measure,
                                  SpringModel model = SpringModel::cf) {
  NetworkSettings settings = in_shear_modulus_form(model);
  settings.strain_measure = measure;
  return settings;
}

/// Springs of these lattice values [N/m], and kappa [Pa].
inline NetworkSettings custom(const LatticeStiffness& stiffness, double volume_modulus) {
  NetworkSettings settings = in_shear_modulus_form(SpringModel::custom);
  settings.constants = {stiffness, volume_modulus};
  return settings;
}

struct NamedModel {
  const char* name;
  SpringModel model;
};
inline constexpr NamedModel models[] = {{"mss-baudet", SpringModel::baudet},
                                        {"mss-nfd", SpringModel::nfd},
                                        {"mss-fd", SpringModel::fd},
                                        {"mss-cf", SpringModel::cf}};

/// The models on cubes: those and mss-affine.
inline constexpr NamedModel models_on_cubes[] = {
    models[0], models[1], models[2], models[3], {"mss-affine", SpringModel::affine}};

/// One vector per node, components uniform in [-size, size].
inline std::vector<Vector3> random_field(std::size_t nodes, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> component(-size, size);
  std::vector<Vector3> field(nodes);
  for (Vector3& v : field) v = {component(random), component(random), component(random)};
  return field;
}

/// Entries uniform in [-size, size].
inline Matrix3 random_gradient(unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-size, size);
  Matrix3 H;
  for (double& value : H.reshaped()) value = entry(random);
  return H;
}

inline Matrix3 random_turn(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> component;
  Eigen::Quaterniond q;
  for (double& value : q.coeffs()) value = component(random);
  return q.normalized().toRotationMatrix();
}

inline std::vector<Vector3> sum(std::vector<Vector3> a, const std::vector<Vector3>& b) {
  for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
  return a;
}

/// The norm of all the vectors as one: the root of the sum of squares.
inline double norm(const std::vector<Vector3>& vectors) {
  double squares = 0;
  for (const Vector3& v : vectors) squares += v.squaredNorm();
  return std::sqrt(squares);
}

inline Vector3 total(const std::vector<Vector3>& vectors) {
  Vector3 all = Vector3::Zero();
  for (const Vector3& v : vectors) all += v;
  return all;
}

/// A plate that only moves along.
inline RigidMotion translation(const Vector3& by) {
  return {
      .translation = by, .axis = Vector3::UnitZ(), .centre = Vector3::Zero(), .angle = 0};
}

}  // namespace springcheck::mss
