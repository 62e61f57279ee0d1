#include "fem_reference/discretisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace springcheck::fem_reference {
namespace {

constexpr NodeIndex unnumbered = std::numeric_limits<NodeIndex>::max();

/// The mesh as deal.II's triangulation, whose vertices are the mesh's nodes.
void build(dealii::Triangulation<3>& triangulation, const Mesh& mesh) {
  std::vector<dealii::Point<3>> vertices;
  for (const Vector3& x : mesh.nodes()) vertices.emplace_back(x.x(), x.y(), x.z());
  std::vector<dealii::CellData<3>> cells;
  for (const CellNodes& nodes : mesh.cells()) {
    constexpr std::array<std::size_t, 8> from_gmsh{0, 1, 3, 2, 4, 5, 7, 6};
    dealii::CellData<3> cell;
    for (std::size_t corner = 0; corner < from_gmsh.size(); ++corner)
      cell.vertices[corner] = nodes[from_gmsh[corner]];
    cells.push_back(cell);
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
  // Every result is read by node number: this must hold, and is cheap to check.
  if (triangulation.get_vertices() != vertices ||
      triangulation.n_active_cells() != mesh.cells().size())
    throw std::logic_error("deal.II renumbered the nodes of " + mesh.source());
}

/// Corners between which the node at `unit_point` of the reference cell lies.
std::vector<unsigned int> corners_around(const dealii::Point<3>& unit_point) {
  std::vector<unsigned int> corners;
  for (unsigned int corner = 0; corner < 8; ++corner) {
    bool near = true;
    for (unsigned int i = 0; i < 3; ++i)
      near = near && std::abs(unit_point[i] - ((corner >> i) & 1U)) < 0.75;
    if (near) corners.push_back(corner);
  }
  return corners;
}

/// Numbers the nodes of all cells: vertices keep their numbers, a triquadratic element's
/// others follow in the order in which the cells meet them.
void number_nodes(Discretisation& body, const dealii::FE_Q<3>& element,
                  const dealii::Triangulation<3>& triangulation) {
  dealii::DoFHandler<3> numbering(triangulation);
  if (element.degree > 1) numbering.distribute_dofs(element);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  std::vector<NodeIndex> number(element.degree > 1 ? numbering.n_dofs() : 0, unnumbered);
  auto place = body.cells.begin();
  for (const auto& shape : triangulation.active_cell_iterators()) {
    Cell& cell = *place++;
    for (const unsigned int corner : shape->vertex_indices())
      cell.nodes.push_back(shape->vertex_index(corner));
    if (element.degree == 1) continue;
    dealii::DoFHandler<3>::active_cell_iterator(&triangulation, shape->level(),
                                                shape->index(), &numbering)
        ->get_dof_indices(indices);
    for (unsigned int a = 8; a < element.dofs_per_cell; ++a) {
      NodeIndex& node = number[indices[a]];
      if (node == unnumbered) {
        node = static_cast<NodeIndex>(body.nodes.size());
        std::vector<NodeIndex> parents;
        Vector3 mean = Vector3::Zero();
        for (const unsigned int corner : corners_around(element.unit_support_point(a))) {
          parents.push_back(cell.nodes[corner]);
          mean += body.nodes[cell.nodes[corner]];
        }
        body.nodes.push_back(mean / static_cast<double>(parents.size()));
        std::ranges::sort(parents);
        body.parents.push_back(std::move(parents));
      }
      cell.nodes.push_back(node);
    }
  }
}

/// Whether two cells' corners differ by a translation, to rounding.
bool same_shape(const Discretisation& body, const Cell& one, const Cell& other) {
  const Vector3 shift = body.nodes[other.nodes[0]] - body.nodes[one.nodes[0]];
  const double size = (body.nodes[one.nodes[7]] - body.nodes[one.nodes[0]]).norm();
  constexpr double rounding = 1e-12;  // of the coordinates, in a body of many cells
  for (std::size_t corner = 1; corner < 8; ++corner)
    if ((body.nodes[other.nodes[corner]] - body.nodes[one.nodes[corner]] - shift).norm() >
        rounding * size)
      return false;
  return true;
}

Shape integrated(const dealii::FEValues<3>& values) {
  const auto points = static_cast<Eigen::Index>(values.n_quadrature_points);
  const auto count = static_cast<Eigen::Index>(values.dofs_per_cell);
  Shape shape{.weights = Eigen::VectorXd(points),
              .gradients = CellVectors::Zero(3, count * (points + 1)),
              .nodes = count,
              .volume = 0};
  auto mean = shape.gradients.rightCols(count);
  for (const unsigned int q : values.quadrature_point_indices()) {
    shape.weights[q] = values.JxW(q);
    shape.volume += values.JxW(q);
    for (const unsigned int a : values.dof_indices())
      for (unsigned int i = 0; i < 3; ++i) {
        const double gradient = values.shape_grad(a, q)[i];
        shape.gradients(i, count * q + a) = gradient;
        mean(i, a) += values.JxW(q) * gradient;
      }
  }
  mean /= shape.volume;
  return shape;
}

void integrate_cells(Discretisation& body, const dealii::FE_Q<3>& element,
                     const dealii::Triangulation<3>& triangulation) {
  dealii::FEValues<3> values(
      element, dealii::QGauss<3>(element.degree + 1),
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
  Cell* last = nullptr;
  auto place = body.cells.begin();
  for (const auto& geometry : triangulation.active_cell_iterators()) {
    Cell& cell = *place++;
    if (last != nullptr && same_shape(body, *last, cell)) {
      cell.shape = last->shape;
      continue;
    }
    values.reinit(geometry);
    cell.shape = std::make_shared<const Shape>(integrated(values));
    last = &cell;
  }
  body.shape_values.resize(values.n_quadrature_points, element.dofs_per_cell);
  for (const unsigned int q : values.quadrature_point_indices())
    for (const unsigned int a : values.dof_indices())
      body.shape_values(q, a) = values.shape_value(a, q);
}

/// int N dA of each region, node by node.
void integrate_regions(Discretisation& body, const Mesh& mesh,
                       const dealii::FE_Q<3>& element,
                       const dealii::Triangulation<3>& triangulation) {
  std::map<FaceNodes, std::vector<std::map<NodeIndex, double>*>> wanted;
  std::map<std::string, std::map<NodeIndex, double>> shares;
  for (const auto& [name, region] : mesh.regions())
    for (const FaceNodes& face : region.faces)
      wanted[ascending(face)].push_back(&shares[name]);
  dealii::FEFaceValues<3> values(element, dealii::QGauss<2>(element.degree + 1),
                                 dealii::update_values | dealii::update_JxW_values);
  auto place = body.cells.begin();
  for (const auto& shape : triangulation.active_cell_iterators()) {
    const Cell& cell = *place++;
    if (!shape->at_boundary()) continue;
    for (const unsigned int f : shape->face_indices()) {
      if (!shape->face(f)->at_boundary()) continue;
      FaceNodes corners;
      for (const unsigned int v : shape->face(f)->vertex_indices())
        corners.push_back(shape->face(f)->vertex_index(v));
      const auto found = wanted.find(ascending(corners));
      if (found == wanted.end()) continue;
      values.reinit(shape, f);
      for (const unsigned int a : values.dof_indices()) {
        if (!element.has_support_on_face(a, f)) continue;
        double area = 0;
        for (const unsigned int q : values.quadrature_point_indices())
          area += values.JxW(q) * values.shape_value(a, q);
        for (auto* region : found->second) (*region)[cell.nodes[a]] += area;
      }
    }
  }
  for (const auto& [name, areas] : shares)
    for (const auto& [node, area] : areas) body.regions[name].push_back({node, area});
}

}  // namespace

Discretisation discretise(const Mesh& mesh, Element element) {
  dealii::Triangulation<3> triangulation;
  build(triangulation, mesh);
  const dealii::FE_Q<3> shapes(element == Element::q2 ? 2 : 1);
  Discretisation body{.vertices = mesh.nodes().size(),
                      .nodes = mesh.nodes(),
                      .parents = {},
                      .cells = std::vector<Cell>(mesh.cells().size()),
                      .shape_values = {},
                      .regions = {}};
  number_nodes(body, shapes, triangulation);
  integrate_cells(body, shapes, triangulation);
  integrate_regions(body, mesh, shapes, triangulation);
  return body;
}

Eigen::VectorXd body_load(const Discretisation& body,
                          const std::function<Vector3(const Vector3&)>& density) {
  Eigen::VectorXd load =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.nodes.size()));
  for (const Cell& cell : body.cells)
    for (Eigen::Index q = 0; q < cell.shape->weights.size(); ++q) {
      Vector3 place = Vector3::Zero();
      for (std::size_t a = 0; a < cell.nodes.size(); ++a)
        place += body.shape_values(q, static_cast<Eigen::Index>(a)) *
                 body.nodes[cell.nodes[a]];
      const Vector3 force = cell.shape->weights[q] * density(place);
      for (std::size_t a = 0; a < cell.nodes.size(); ++a)
        load.segment<3>(3 * cell.nodes[a]) +=
            body.shape_values(q, static_cast<Eigen::Index>(a)) * force;
    }
  return load;
}

Eigen::VectorXd traction_load(const Discretisation& body, const Traction& traction) {
  Eigen::VectorXd load =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.nodes.size()));
  for (const auto& [node, area] : body.regions.at(traction.region))
    load.segment<3>(3 * node) += area * traction.stress;
  return load;
}

Vector3 mean_displacement(const Discretisation& body, const std::string& region,
                          const Eigen::VectorXd& displacements) {
  Vector3 integral = Vector3::Zero();
  double whole = 0;
  for (const auto& [node, area] : body.regions.at(region)) {
    integral += area * displacements.segment<3>(3 * node);
    whole += area;
  }
  return integral / whole;
}

CellVectors of_cell(const Eigen::VectorXd& nodal, const Cell& cell) {
  CellVectors values(3, cell.nodes.size());
  for (std::size_t a = 0; a < cell.nodes.size(); ++a)
    values.col(static_cast<Eigen::Index>(a)) = nodal.segment<3>(3 * cell.nodes[a]);
  return values;
}

}  // namespace springcheck::fem_reference
