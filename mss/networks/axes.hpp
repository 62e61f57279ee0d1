#pragma once

#include <Eigen/Core>
#include <span>

#include "meshing/mesh.hpp"

namespace springcheck::mss {

/// Axes of virtual springs: the 6 of the icosahedron; those and the 10 of the
/// dodecahedron dual to it; or 25 of a cube, its edges, diagonals of faces and of itself
/// and (1, 1, 3) with all that are like it.
enum class Axes { six, sixteen, twenty_five };

/// A unit vector, and 15 times its weight in a mean over directions.
struct Axis {
  Vector3 n;
  double weight;  // w/mu
};

/// Weights in means over directions: of six 1/6 each; of sixteen 25/420 for the
/// icosahedron's, 27/420 for the dodecahedron's; of twenty-five 8/315, 128/2835, 27/640
/// and 14641/362880. Means of polynomials in n are exact up to degree 5, 9, 11.
/// Source: the last is Lebedev, Quadratures on a sphere (1976), of 50 points.
std::span<const Axis> all_of(Axes axes);

/// One number for each axis.
using AxisValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 25, 1>;

}  // namespace springcheck::mss
