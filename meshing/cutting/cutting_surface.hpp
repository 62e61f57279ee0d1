#pragma once

#include <variant>
#include <vector>

#include "meshing/basics/vector3.hpp"

namespace springcheck {

/// The points x with normal.x = offset [m], for a normal of unit length, which points
/// upwards.
struct Plane {
  Vector3 normal;
  double offset;

  friend bool operator==(const Plane&, const Plane&) = default;
};

/// With edges along the axes. Above its walls is outside.
struct Box {
  Vector3 low, high;  // corners [m], each component of the first below the second's

  friend bool operator==(const Box&, const Box&) = default;
};

/// The wall around an axis; above it is outside.
struct Cylinder {
  Vector3 from, to;  // the ends of its axis [m]
  double radius;     // [m]

  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

/// The sheet that a blade leaves behind which goes along the points, everywhere as deep.
/// Above it is the left of its way, seen with the depth pointing down.
struct Blade {
  std::vector<Vector3> points;  // [m], two at least
  Vector3 depth;                // [m], not along the way

  friend bool operator==(const Blade&, const Blade&) = default;
};

using CuttingSurface = std::variant<Plane, Box, Cylinder, Blade>;

/// How far x is above the surface [m], negative below it, as if its ends went on straight
/// without end. Outside a box it is the largest of the distances along the axes.
double height_over(const CuttingSurface& surface, const Vector3& x);

/// How far x is past the ends of a cylinder or a sheet [m]; 0 where the surface has a
/// point across from it.
double past_end(const CuttingSurface& surface, const Vector3& x);

/// Whether the surface encloses a part of space: a box, a cylinder.
bool encloses(const CuttingSurface& surface);

}  // namespace springcheck
