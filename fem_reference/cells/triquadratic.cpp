#include "fem_reference/cells/triquadratic.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <limits>

namespace springcheck::fem_reference {
namespace {

constexpr NodeIndex unnumbered = std::numeric_limits<NodeIndex>::max();

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

}  // namespace

void add_intermediate_nodes(Discretisation& body,
                            const dealii::Triangulation<3>& triangulation) {
  const dealii::FE_Q<3> element(2);
  dealii::DoFHandler<3> numbering(triangulation);
  numbering.distribute_dofs(element);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  std::vector<NodeIndex> number(numbering.n_dofs(), unnumbered);
  auto place = body.cells.begin();
  for (const auto& shape : numbering.active_cell_iterators()) {
    Cell& cell = *place++;
    shape->get_dof_indices(indices);
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

std::map<std::string, std::vector<AreaShare>> triquadratic_area_shares(
    const Mesh& mesh, const Discretisation& body,
    const dealii::Triangulation<3>& triangulation) {
  std::map<FaceNodes, std::vector<std::map<NodeIndex, double>*>> wanted;
  std::map<std::string, std::map<NodeIndex, double>> areas;
  for (const auto& [name, region] : mesh.regions())
    for (const FaceNodes& face : region.faces)
      wanted[ascending(face)].push_back(&areas[name]);
  const dealii::FE_Q<3> element(2);
  dealii::FEFaceValues<3> values(element, dealii::QGauss<2>(3),
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
  std::map<std::string, std::vector<AreaShare>> shares;
  for (const auto& [name, by_node] : areas)
    for (const auto& [node, area] : by_node) shares[name].push_back({node, area});
  return shares;
}

}  // namespace springcheck::fem_reference
