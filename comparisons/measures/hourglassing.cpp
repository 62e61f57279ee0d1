#include "comparisons/measures/hourglassing.hpp"

#include <cmath>

namespace springcheck {
namespace {

/// The best affine fit to the displacements of a cell's corners, and what it leaves.
struct Fit {
  Eigen::Matrix3d gradient;
  Eigen::Matrix<double, 3, 8> rest;  // w, a column for each corner [m]
};

Fit fit(const Mesh& mesh, const CellNodes& cell, std::span<const Vector3> displacements) {
  Eigen::Matrix<double, 3, 8> x, u;
  for (Eigen::Index a = 0; a < 8; ++a) {
    const NodeIndex node = cell[static_cast<std::size_t>(a)];
    x.col(a) = mesh.nodes()[node];
    u.col(a) = displacements[node];
  }
  x.colwise() -= x.rowwise().mean().eval();
  u.colwise() -= u.rowwise().mean().eval();
  const Eigen::Matrix3d gradient =
      u * x.transpose() * (x * x.transpose()).inverse().eval();
  return {.gradient = gradient, .rest = u - gradient * x};
}

/// Mean square of the cells' edges [m^2].
double square_edges(const Mesh& mesh) {
  double sum = 0, count = 0;
  for (const CellNodes& cell : mesh.cells())
    for (const LocalEdge& edge : edges(CellType::hexahedron)) {
      sum += (mesh.nodes()[cell[edge[1]]] - mesh.nodes()[cell[edge[0]]]).squaredNorm();
      ++count;
    }
  return sum / count;
}

}  // namespace

std::optional<Hourglassing> measure_hourglassing(const Mesh& mesh,
                                                 std::span<const Vector3> displacements) {
  if (mesh.count(CellType::hexahedron) != mesh.cells().size()) return std::nullopt;
  struct Node {
    Vector3 sum = Vector3::Zero();
    double squares = 0, cells = 0;
    bool is_inside = true;
  };
  std::vector<Node> nodes(mesh.nodes().size());
  for (const NodeIndex n : mesh.boundary().nodes) nodes[n].is_inside = false;
  double strains = 0;  // sum of |E|^2
  for (const CellNodes& cell : mesh.cells()) {
    const Fit here = fit(mesh, cell, displacements);
    const Eigen::Matrix3d& H = here.gradient;
    strains += ((H + H.transpose() + H.transpose() * H) / 2).squaredNorm();
    for (std::size_t a = 0; a < 8; ++a) {
      const Vector3 w = here.rest.col(static_cast<Eigen::Index>(a));
      Node& node = nodes[cell[a]];
      node.sum += w;
      node.squares += w.squaredNorm();
      ++node.cells;
    }
  }
  double alternating = 0, all = 0, inside = 0;
  for (const Node& node : nodes) {
    if (!node.is_inside) continue;
    alternating += (node.sum / node.cells).squaredNorm();
    all += node.squares / node.cells;
    ++inside;
  }
  if (inside == 0) return std::nullopt;
  if (strains == 0) return Hourglassing{.alternation = {}, .amplitude = 0};
  const double strain = std::sqrt(strains / static_cast<double>(mesh.cells().size()));
  const auto amplitude = [&](double squares) {
    return std::sqrt(squares / inside / square_edges(mesh)) / strain;
  };
  constexpr double rounding = 1e-7;
  Hourglassing seen{.alternation = {}, .amplitude = amplitude(alternating)};
  if (amplitude(all) >= rounding) seen.alternation = alternating / all;
  return seen;
}

bool is_hourglassing(const Hourglassing& hourglassing) {
  return hourglassing.alternation > *hourglassing_above.alternation &&
         hourglassing.amplitude > hourglassing_above.amplitude;
}

}  // namespace springcheck
