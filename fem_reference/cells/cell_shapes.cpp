#include "fem_reference/cells/cell_shapes.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_pyramid_p.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_wedge_p.h>
#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <deque>

namespace springcheck::fem_reference {
namespace {

/// A regular pattern repeats itself after no more cells of a type than this.
constexpr std::size_t longest_pattern = 24;

std::unique_ptr<const dealii::FiniteElement<3>> functions_on(CellType type,
                                                             Element element) {
  switch (type) {
    case CellType::tetrahedron:
      return std::make_unique<dealii::FE_SimplexP<3>>(1);
    case CellType::pyramid:
      return std::make_unique<dealii::FE_PyramidP<3>>(1);
    case CellType::prism:
      return std::make_unique<dealii::FE_WedgeP<3>>(1);
    case CellType::hexahedron:
      break;
  }
  return std::make_unique<dealii::FE_Q<3>>(element == Element::q2 ? 2 : 1);
}

/// Three points in the triangle (exact to second degree), the same for all its corners:
/// those of QGaussWedge are not, and make forces depend on the corner a prism begins
/// with.
dealii::Quadrature<3> points_on_prism() {
  const dealii::QWitherdenVincentSimplex<2> triangle(1, false);
  const dealii::QGauss<1> height(2);
  std::vector<dealii::Point<3>> points;
  std::vector<double> weights;
  for (unsigned int z = 0; z < height.size(); ++z)
    for (unsigned int xy = 0; xy < triangle.size(); ++xy) {
      points.emplace_back(triangle.point(xy)[0], triangle.point(xy)[1],
                          height.point(z)[0]);
      weights.push_back(triangle.weight(xy) * height.weight(z));
    }
  return {points, weights};
}

dealii::Quadrature<3> points_on(CellType type, Element element) {
  switch (type) {
    case CellType::tetrahedron:
      return dealii::QGaussSimplex<3>(1);
    case CellType::pyramid:
      return dealii::QGaussPyramid<3>(2);
    case CellType::prism:
      return points_on_prism();
    case CellType::hexahedron:
      break;
  }
  return dealii::QGauss<3>(element == Element::q2 ? 3 : 2);
}

/// Integrates cells of one type.
class Integration {
 public:
  Integration(CellType type, Element element)
      : functions_(functions_on(type, element)),
        at_points_(functions_->reference_cell().get_default_linear_mapping<3>(),
                   *functions_, points_on(type, element),
                   dealii::update_values | dealii::update_gradients |
                       dealii::update_JxW_values) {}

  std::shared_ptr<const Shape> over(
      const dealii::Triangulation<3>::active_cell_iterator& cell) {
    at_points_.reinit(cell);
    if (!values_) values_ = std::make_shared<const Eigen::MatrixXd>(values());
    const auto points = static_cast<Eigen::Index>(at_points_.n_quadrature_points);
    const auto count = static_cast<Eigen::Index>(at_points_.dofs_per_cell);
    Shape shape{.values = values_,
                .weights = Eigen::VectorXd(points),
                .gradients = CellVectors::Zero(3, count * (points + 1)),
                .nodes = count,
                .volume = 0};
    auto mean = shape.gradients.rightCols(count);
    for (const unsigned int q : at_points_.quadrature_point_indices()) {
      const double weight = at_points_.JxW(q);
      shape.weights[q] = weight;
      shape.volume += weight;
      for (const unsigned int a : at_points_.dof_indices())
        for (unsigned int i = 0; i < 3; ++i) {
          const double gradient = at_points_.shape_grad(a, q)[i];
          shape.gradients(i, count * q + a) = gradient;
          mean(i, a) += weight * gradient;
        }
    }
    mean /= shape.volume;
    return std::make_shared<const Shape>(std::move(shape));
  }

 private:
  [[nodiscard]] Eigen::MatrixXd values() const {
    Eigen::MatrixXd values(at_points_.n_quadrature_points, at_points_.dofs_per_cell);
    for (const unsigned int q : at_points_.quadrature_point_indices())
      for (const unsigned int a : at_points_.dof_indices())
        values(q, a) = at_points_.shape_value(a, q);
    return values;
  }

  std::unique_ptr<const dealii::FiniteElement<3>> functions_;
  dealii::FEValues<3> at_points_;
  std::shared_ptr<const Eigen::MatrixXd> values_;  // the same in every cell
};

/// Whether two cells of a type differ by a translation, to rounding.
bool same_shape(const std::vector<Vector3>& nodes, const CellNodes& one,
                const CellNodes& other) {
  const Vector3 shift = nodes[other[0]] - nodes[one[0]];
  double size = 0, difference = 0;
  for (std::size_t corner = 1; corner < one.size(); ++corner) {
    size = std::max(size, (nodes[one[corner]] - nodes[one[0]]).norm());
    difference =
        std::max(difference, (nodes[other[corner]] - nodes[one[corner]] - shift).norm());
  }
  constexpr double rounding = 1e-12;  // of the coordinates, in a body of many cells
  return difference <= rounding * size;
}

}  // namespace

std::vector<std::shared_ptr<const Shape>> cell_shapes(
    const Mesh& mesh, const dealii::Triangulation<3>& triangulation, Element element) {
  std::vector<std::shared_ptr<const Shape>> shapes;
  shapes.reserve(mesh.cells().size());
  std::unique_ptr<Integration> integration;
  std::deque<std::size_t> recent;  // cells of one type and of different shapes
  for (const auto& geometry : triangulation.active_cell_iterators()) {
    const std::size_t c = shapes.size();
    const CellNodes& cell = mesh.cells()[c];
    if (c == 0 || cell.size() != mesh.cells()[c - 1].size()) {
      integration = std::make_unique<Integration>(type_of(cell), element);
      recent.clear();
    }
    const auto like = std::ranges::find_if(recent, [&](std::size_t other) {
      return same_shape(mesh.nodes(), mesh.cells()[other], cell);
    });
    if (like != recent.end()) {
      shapes.push_back(shapes[*like]);
      continue;
    }
    shapes.push_back(integration->over(geometry));
    recent.push_front(c);
    if (recent.size() > longest_pattern) recent.pop_back();
  }
  return shapes;
}

}  // namespace springcheck::fem_reference
