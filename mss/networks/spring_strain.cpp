#include "mss/networks/spring_strain.hpp"

#include <cmath>

namespace springcheck::mss {
namespace {

/// l/L - 1 of a spring whose ends move apart by `move`, to the digits of small strains.
double strain(const Vector3& rest, const Vector3& move) {
  const Vector3 d = rest + move;
  const double L = rest.norm();
  return move.dot(d + rest) / ((d.norm() + L) * L);
}

}  // namespace

std::vector<double> largest_spring_strains(const Network& network,
                                           const std::vector<Vector3>& displacements) {
  const Cells& cells = network.cells;
  std::vector<double> largest(cells.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto consider = [&](double e) {
      if (std::abs(e) > std::abs(largest[c])) largest[c] = e;
    };
    const auto nodes = cells.nodes(c);
    if (network.cell_springs == RestLength::constant)
      for (const CellSpring& spring : cells.springs(c))
        consider(strain(spring.rest, displacements[nodes[spring.ends[1]]] -
                                         displacements[nodes[spring.ends[0]]]));
    if (network.spring_modulus > 0)
      for (const double e :
           axis_strains(network.axes, cells.displacement_gradient(c, displacements)))
        consider(e);
  }
  return largest;
}

}  // namespace springcheck::mss
