#include "mss/networks/axes.hpp"

#include <array>
#include <numbers>

namespace springcheck::mss {
namespace {

using std::numbers::phi;

/// The icosahedron's axes: (phi, 1, 0), (phi, -1, 0) and cyclic, normalised. Then the
/// dodecahedron's: (0, 1/phi, phi), (0, -1/phi, phi) and cyclic, (1, 1, 1) and its
/// reflections.
std::array<Axis, 16> axes_with(double of_icosahedron, double of_dodecahedron) {
  std::array<Axis, 16> axes;
  std::size_t next = 0;
  const auto add = [&](const Vector3& along, double weight) {
    axes[next++] = {.n = along.normalized(), .weight = weight};
  };
  const auto turned = [](Eigen::Index by, double first, double second, double third) {
    Vector3 v;
    v[by] = first;
    v[(by + 1) % 3] = second;
    v[(by + 2) % 3] = third;
    return v;
  };
  for (Eigen::Index by = 0; by < 3; ++by)
    for (const double side : {1., -1.}) add(turned(by, phi, side, 0), of_icosahedron);
  for (Eigen::Index by = 0; by < 3; ++by)
    for (const double side : {1., -1.})
      add(turned(by, 0, side / phi, phi), of_dodecahedron);
  for (const double x : {1., -1.})
    for (const double y : {1., -1.}) add({x, y, 1}, of_dodecahedron);
  return axes;
}

std::array<Axis, 25> axes_of_a_cube() {
  std::array<Axis, 25> axes;
  std::size_t next = 0;
  for (const double z : {0., 1., 3.})
    for (const double y : {-3., -1., 0., 1., 3.})
      for (const double x : {-3., -1., 0., 1., 3.}) {
        const bool first_of_pair = z > 0 || y > 0 || (y == 0 && x > 0);
        if (!first_of_pair) continue;
        const Vector3 along(x, y, z);
        const auto squares = static_cast<int>(along.squaredNorm());
        const double weight = squares == 1    ? 8. / 315
                              : squares == 2  ? 128. / 2835
                              : squares == 3  ? 27. / 640
                              : squares == 11 ? 14641. / 362880
                                              : 0;  // none of them
        if (weight != 0) axes[next++] = {.n = along.normalized(), .weight = 15 * weight};
      }
  return axes;
}

}  // namespace

std::span<const Axis> all_of(Axes which) {
  static const std::array six = axes_with(15. / 6, 0),
                          sixteen = axes_with(15. * 25 / 420, 15. * 27 / 420);
  static const std::array twenty_five = axes_of_a_cube();
  switch (which) {
    case Axes::six:
      break;
    case Axes::sixteen:
      return sixteen;
    case Axes::twenty_five:
      return twenty_five;
  }
  return std::span(six).first<6>();
}

}  // namespace springcheck::mss
