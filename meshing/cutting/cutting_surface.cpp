#include "meshing/cutting/cutting_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace springcheck {
namespace {

/// A point along a line, seen from where it begins.
struct OnLine {
  double along;   // from its first end [m]
  double length;  // [m]
  Vector3 off;    // from the line to the point [m]

  [[nodiscard]] double past_end() const {
    return std::max({-along, along - length, 0.});  // [m]
  }
};

OnLine on_line(const Vector3& from, const Vector3& to, const Vector3& x) {
  const double length = (to - from).norm();
  const Vector3 way = (to - from) / length;
  const double along = way.dot(x - from);
  return {.along = along, .length = length, .off = x - from - along * way};
}

/// What is nearest to a point of a blade's way, both seen along the depth.
struct OnBlade {
  double distance = std::numeric_limits<double>::max();
  Vector3 nearest{};    // on the way
  Vector3 normal{};     // upwards; at a bend, the sum of both stretches'
  double past_end = 0;  // of the way [m]
};

OnBlade on_blade(const Blade& blade, const Vector3& x) {
  const auto seen = [&](const Vector3& point) -> Vector3 {
    return point - blade.depth * blade.depth.dot(point) / blade.depth.squaredNorm();
  };
  const auto stretch = [&](std::size_t i) -> Vector3 {
    return blade.points[i + 1] - blade.points[i];
  };
  const auto normal = [&](std::size_t i) -> Vector3 {
    return stretch(i).cross(blade.depth).normalized();
  };
  OnBlade best;
  const std::size_t last = blade.points.size() - 2;
  for (std::size_t i = 0; i <= last; ++i) {
    const OnLine place =
        on_line(seen(blade.points[i]), seen(blade.points[i + 1]), seen(x));
    const double along = std::clamp(place.along, 0., place.length);
    const double distance = std::hypot(place.off.norm(), place.along - along);
    if (distance >= best.distance) continue;
    best = {.distance = distance,
            .nearest = blade.points[i] + along / place.length * stretch(i),
            .normal = normal(i)};
    if (place.along < 0 && i > 0)
      best.normal += normal(i - 1);
    else if (place.along > place.length && i < last)
      best.normal += normal(i + 1);
    else
      best.past_end = place.past_end();
  }
  return best;
}

struct Height {
  const Vector3& x;

  double operator()(const Plane& plane) const {
    return plane.normal.dot(x) - plane.offset;
  }
  double operator()(const Box& box) const {
    return std::max((box.low - x).maxCoeff(), (x - box.high).maxCoeff());
  }
  double operator()(const Cylinder& cylinder) const {
    return on_line(cylinder.from, cylinder.to, x).off.norm() - cylinder.radius;
  }
  double operator()(const Blade& blade) const {
    const OnBlade place = on_blade(blade, x);
    return place.normal.normalized().dot(x - place.nearest);
  }
};

struct PastEnd {
  const Vector3& x;

  double operator()(const Plane&) const { return 0; }
  double operator()(const Box&) const { return 0; }
  double operator()(const Cylinder& cylinder) const {
    return on_line(cylinder.from, cylinder.to, x).past_end();
  }
  double operator()(const Blade& blade) const {
    const OnBlade place = on_blade(blade, x);
    const OnLine deep = on_line(place.nearest, place.nearest + blade.depth, x);
    return std::hypot(place.past_end, deep.past_end());
  }
};

}  // namespace

double height_over(const CuttingSurface& surface, const Vector3& x) {
  return std::visit(Height{x}, surface);
}

double past_end(const CuttingSurface& surface, const Vector3& x) {
  return std::visit(PastEnd{x}, surface);
}

bool encloses(const CuttingSurface& surface) {
  return std::holds_alternative<Box>(surface) ||
         std::holds_alternative<Cylinder>(surface);
}

}  // namespace springcheck
