#pragma once

#include "fem_reference/explicit/explicit_element.hpp"
#include "tests/fem_reference/bodies.hpp"

// Displacements and sums that several tests of the explicit elements are made from.
namespace springcheck::fem_reference {

inline constexpr ExplicitElement explicit_elements[] = {ExplicitElement::one_point,
                                                        ExplicitElement::eight_points};

inline std::string words(ExplicitElement element) {
  return element == ExplicitElement::one_point ? "one point" : "eight points";
}

inline std::vector<Vector3> at_nodes(
    const Mesh& mesh, const std::function<Vector3(const Vector3&)>& field) {
  std::vector<Vector3> values;
  for (const Vector3& x : mesh.nodes()) values.push_back(field(x));
  return values;
}

inline std::vector<Vector3> random_at_nodes(const Mesh& mesh, double size,
                                            unsigned seed) {
  RandomVectors random(size, seed);
  return at_nodes(mesh, [&](const Vector3&) { return random(); });
}

inline double longest(const std::vector<Vector3>& vectors) {
  double length = 0;
  for (const Vector3& v : vectors) length = std::max(length, v.norm());
  return length;
}

inline RigidMotion moved_by(const Vector3& translation) {
  return {.translation = translation,
          .axis = Vector3::UnitZ(),
          .centre = Vector3::Zero(),
          .angle = 0};
}

}  // namespace springcheck::fem_reference
