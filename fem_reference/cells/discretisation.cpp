#include "fem_reference/cells/discretisation.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <stdexcept>

#include "fem_reference/cells/cell_shapes.hpp"
#include "fem_reference/cells/triquadratic.hpp"
#include "meshing/loads/traction.hpp"

namespace springcheck::fem_reference {
namespace {

/// The place in CellNodes of each of deal.II's vertices of a cell.
std::span<const std::uint8_t> deal_ii_order(CellType type) {
  static constexpr std::array<std::uint8_t, 5> pyramid{0, 1, 3, 2, 4};
  static constexpr std::array<std::uint8_t, 6> same{0, 1, 2, 3, 4, 5};
  switch (type) {
    case CellType::hexahedron:
      return grid_corners;
    case CellType::pyramid:
      return pyramid;
    case CellType::prism:
    case CellType::tetrahedron:
      break;
  }
  return std::span(same).first(node_count(type));
}

/// The cells with their nodes in deal.II's order.
std::vector<Cell> cells_of(const Mesh& mesh) {
  std::vector<Cell> cells;
  for (const CellNodes& nodes : mesh.cells()) {
    Cell& cell = cells.emplace_back();
    for (const std::uint8_t place : deal_ii_order(type_of(nodes)))
      cell.nodes.push_back(nodes[place]);
  }
  return cells;
}

/// The cells as deal.II's triangulation, whose vertices are the mesh's nodes.
void build(dealii::Triangulation<3>& triangulation, const Mesh& mesh,
           const std::vector<Cell>& cells) {
  std::vector<dealii::Point<3>> vertices;
  for (const Vector3& x : mesh.nodes()) vertices.emplace_back(x.x(), x.y(), x.z());
  std::vector<dealii::CellData<3>> data;
  for (const Cell& cell : cells) {
    dealii::CellData<3>& one = data.emplace_back(cell.nodes.size());
    std::ranges::copy(cell.nodes, one.vertices.begin());
  }
  triangulation.create_triangulation(vertices, data, dealii::SubCellData());
  // Every result is read by the numbers of nodes and cells: they must hold, and that is
  // cheap to check.
  bool holds = triangulation.get_vertices() == vertices &&
               triangulation.n_active_cells() == cells.size();
  auto cell = cells.begin();
  for (const auto& shape : triangulation.active_cell_iterators()) {
    if (!holds) break;
    for (const unsigned int v : shape->vertex_indices())
      holds = holds && shape->vertex_index(v) == cell->nodes[v];
    ++cell;
  }
  if (!holds)
    throw std::logic_error("deal.II renumbered the nodes or cells of " + mesh.source());
}

/// int N dA of each region, node by node, for linear and bilinear shape functions.
std::map<std::string, std::vector<AreaShare>> area_shares(const Mesh& mesh) {
  std::map<std::string, std::vector<AreaShare>> shares;
  for (const auto& [name, region] : mesh.regions()) {
    const std::vector<double> areas = nodal_areas(mesh, region);
    for (const NodeIndex node : region.nodes) shares[name].push_back({node, areas[node]});
  }
  return shares;
}

}  // namespace

Discretisation discretise(const Mesh& mesh, Element element) {
  assert(element != Element::q2 ||
         mesh.count(CellType::hexahedron) == mesh.cells().size());
  Discretisation body{
      .vertices = mesh.nodes().size(), .nodes = mesh.nodes(), .cells = cells_of(mesh)};
  dealii::Triangulation<3> triangulation;
  build(triangulation, mesh, body.cells);
  const auto shapes = cell_shapes(mesh, triangulation, element);
  for (std::size_t c = 0; c < shapes.size(); ++c) body.cells[c].shape = shapes[c];
  if (element == Element::q2) {
    add_intermediate_nodes(body, triangulation);
    body.regions = triquadratic_area_shares(mesh, body, triangulation);
  } else {
    body.regions = area_shares(mesh);
  }
  if (element == Element::q1_nodal) {
    body.nodal_patches = nodal_patches(mesh, NodalPatchCells::all);
    body.tetrahedron_patches = nodal_patches(mesh, NodalPatchCells::tetrahedra);
  }
  return body;
}

std::vector<std::vector<NodeIndex>> patches(const Discretisation& body) {
  std::vector<std::vector<NodeIndex>> nodes;
  for (const Cell& cell : body.cells) nodes.push_back(cell.nodes);
  return nodes;
}

CellVectors of_cell(const Eigen::VectorXd& nodal, const Cell& cell) {
  CellVectors values(3, cell.nodes.size());
  for (std::size_t a = 0; a < cell.nodes.size(); ++a)
    values.col(static_cast<Eigen::Index>(a)) = nodal.segment<3>(3 * cell.nodes[a]);
  return values;
}

}  // namespace springcheck::fem_reference
