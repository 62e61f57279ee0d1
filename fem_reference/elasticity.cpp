#include "fem_reference/elasticity.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "fem_reference/cell.hpp"
#include "fem_reference/factor.hpp"

namespace springcheck::fem_reference {
namespace {

constexpr int cell_dofs = 24;

/// The mesh as deal.II's triangulation, whose vertices are the mesh's nodes.
void build(dealii::Triangulation<3>& triangulation, const Mesh& mesh) {
  std::vector<dealii::Point<3>> vertices;
  for (const Vector3& x : mesh.nodes()) vertices.emplace_back(x.x(), x.y(), x.z());
  std::vector<dealii::CellData<3>> cells;
  for (const Hexahedron& nodes : mesh.hexahedra()) {
    constexpr std::array<std::size_t, 8> from_gmsh{0, 1, 3, 2, 4, 5, 7, 6};
    dealii::CellData<3> cell;
    for (std::size_t corner = 0; corner < from_gmsh.size(); ++corner)
      cell.vertices[corner] = nodes[from_gmsh[corner]];
    cells.push_back(cell);
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
  // Every result is read by node number: this must hold, and is cheap to check.
  if (triangulation.get_vertices() != vertices ||
      triangulation.n_active_cells() != mesh.hexahedra().size())
    throw std::logic_error("deal.II renumbered the nodes of " + mesh.source());
}

std::vector<Cell> integrate_shapes(const dealii::Triangulation<3>& triangulation) {
  const dealii::FE_Q<3> element(1);
  const dealii::QGauss<3> gauss(2);
  dealii::FEValues<3> values(
      element, gauss,
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
  std::vector<Cell> cells;
  cells.reserve(triangulation.n_active_cells());
  for (const auto& shape : triangulation.active_cell_iterators()) {
    values.reinit(shape);
    Cell cell{.nodes = {}, .points = {}, .shares = {}, .volume = 0};
    for (const unsigned int q : values.quadrature_point_indices()) {
      cell.points[q].weight = values.JxW(q);
      cell.volume += values.JxW(q);
      for (const unsigned int a : shape->vertex_indices()) {
        for (unsigned int i = 0; i < 3; ++i)
          cell.points[q].gradients(i, a) = values.shape_grad(a, q)[i];
        cell.shares[a] += values.JxW(q) * values.shape_value(a, q);
      }
    }
    for (const unsigned int a : shape->vertex_indices())
      cell.nodes[a] = shape->vertex_index(a);
    cells.push_back(cell);
  }
  return cells;
}

CellVectors of_cell(const Eigen::VectorXd& nodal, const Cell& cell) {
  CellVectors values;
  for (std::size_t a = 0; a < cell.nodes.size(); ++a)
    values.col(static_cast<Eigen::Index>(a)) = nodal.segment<3>(3 * cell.nodes[a]);
  return values;
}

}  // namespace

struct Elasticity::Implementation {
  CellLaw law;
  double density;
  std::vector<Cell> cells;
  std::vector<Eigen::Index> unknown;  // of each dof, -1 when prescribed
  Eigen::Index unknowns = 0;
  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> tangent;  // of all dofs
  double largest_stiffness = 0;
  SparseMatrix free_block;  // lower triangle
  SymmetricFactor factor;
  bool factored = false;

  void number_unknowns(std::size_t nodes, std::span<const NodeIndex> prescribed) {
    unknown.assign(3 * nodes, 0);
    for (const NodeIndex node : prescribed)
      for (std::size_t i = 0; i < 3; ++i) unknown[3 * node + i] = -1;
    for (Eigen::Index& number : unknown)
      if (number == 0) number = unknowns++;
  }

  static std::array<unsigned int, cell_dofs> dofs(const Cell& cell) {
    std::array<unsigned int, cell_dofs> numbers;
    for (std::size_t i = 0; i < cell_dofs; ++i)
      numbers[i] = 3 * cell.nodes[i / 3] + static_cast<unsigned int>(i % 3);
    return numbers;
  }

  void make_pattern() {
    dealii::DynamicSparsityPattern entries(static_cast<unsigned int>(unknown.size()));
    for (const Cell& cell : cells) {
      auto numbers = dofs(cell);
      std::ranges::sort(numbers);
      for (const unsigned int row : numbers)
        entries.add_entries(row, numbers.begin(), numbers.end(), true);
    }
    pattern.copy_from(entries);
    tangent.reinit(pattern);
    std::vector<Eigen::Triplet<double>> free_entries;
    for_free_entries([&](Eigen::Index row, Eigen::Index column, double) {
      free_entries.emplace_back(row, column, 0.0);
    });
    free_block.resize(unknowns, unknowns);
    free_block.setFromTriplets(free_entries.begin(), free_entries.end());
  }

  /// Visits the lower triangle of the free block column by column, rows ascending: the
  /// order in which Eigen stores it. (By symmetry a column is deal.II's row, which lists
  /// the diagonal first.)
  template <class Visitor>
  void for_free_entries(const Visitor& visit) const {
    for (unsigned int dof = 0; dof < unknown.size(); ++dof) {
      if (unknown[dof] < 0) continue;
      for (auto entry = tangent.begin(dof); entry != tangent.end(dof); ++entry)
        if (entry->column() >= dof && unknown[entry->column()] >= 0)
          visit(unknown[entry->column()], unknown[dof], entry->value());
    }
  }
};

Elasticity::Elasticity(const Mesh& mesh, const Material& material,
                       const Settings& settings, std::span<const NodeIndex> prescribed)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  self.law = cell_law(settings, lame_constants(material));
  self.density = material.density;
  dealii::Triangulation<3> triangulation;
  build(triangulation, mesh);
  self.cells = integrate_shapes(triangulation);
  self.number_unknowns(mesh.nodes().size(), prescribed);
  self.make_pattern();
}

Elasticity::~Elasticity() = default;

Elasticity::Internal Elasticity::internal(const Eigen::VectorXd& displacements) const {
  Internal sum{.energy = 0,
               .forces = Eigen::VectorXd::Zero(displacements.size()),
               .smallest_jacobian = std::numeric_limits<double>::infinity(),
               .mean_gradient = 0};
  double volume = 0;
  for (const Cell& cell : implementation_->cells) {
    const CellState state =
        cell_state(implementation_->law, cell, of_cell(displacements, cell));
    sum.energy += state.energy;
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      sum.forces.segment<3>(3 * cell.nodes[a]) +=
          state.forces.col(static_cast<Eigen::Index>(a));
    sum.smallest_jacobian = std::min(sum.smallest_jacobian, state.smallest_jacobian);
    sum.mean_gradient += state.gradient_square;
    volume += cell.volume;
  }
  sum.mean_gradient = std::sqrt(sum.mean_gradient / volume);
  return sum;
}

Eigen::VectorXd Elasticity::weight(const Vector3& gravity) const {
  Eigen::VectorXd forces =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(implementation_->unknown.size()));
  for (const Cell& cell : implementation_->cells)
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      forces.segment<3>(3 * cell.nodes[a]) +=
          implementation_->density * cell.shares[a] * gravity;
  return forces;
}

bool Elasticity::factor(const Eigen::VectorXd& displacements) {
  Implementation& self = *implementation_;
  if (self.law.law == Law::hooke && self.factored)
    return true;  // the tangent is constant
  self.tangent = 0;
  dealii::FullMatrix<double> block(cell_dofs, cell_dofs);
  std::vector<unsigned int> dofs(cell_dofs);
  for (const Cell& cell : self.cells) {
    const CellMatrix K = cell_tangent(self.law, cell, of_cell(displacements, cell));
    std::copy_n(K.data(), K.size(), &block(0, 0));  // symmetric: rows are columns
    std::ranges::copy(Implementation::dofs(cell), dofs.begin());
    self.tangent.add(dofs, block, false);
  }
  double* value = self.free_block.valuePtr();
  self.for_free_entries([&](Eigen::Index, Eigen::Index, double v) { *value++ = v; });
  self.largest_stiffness = 0;
  for (unsigned int dof = 0; dof < self.unknown.size(); ++dof)
    self.largest_stiffness =
        std::max(self.largest_stiffness, std::abs(self.tangent.diag_element(dof)));
  self.factored = self.unknowns == 0 || self.factor.factor_definite(self.free_block);
  return self.factored;
}

bool Elasticity::factor_indefinite() {
  return implementation_->factor.factor_indefinite(implementation_->free_block);
}

int Elasticity::negative_eigenvalues() const {
  return implementation_->factor.negative_pivots();
}

Eigen::VectorXd Elasticity::step(const Eigen::VectorXd& unbalanced,
                                 const Eigen::VectorXd& increment) const {
  const Implementation& self = *implementation_;
  const auto dofs = static_cast<unsigned int>(increment.size());
  Eigen::VectorXd answer = increment - free_part(increment);
  dealii::Vector<double> moved(dofs), pushed(dofs);
  std::ranges::copy(answer, moved.begin());
  self.tangent.vmult(pushed, moved);
  Eigen::VectorXd right(self.unknowns);
  for (unsigned int dof = 0; dof < dofs; ++dof)
    if (self.unknown[dof] >= 0) right[self.unknown[dof]] = unbalanced[dof] - pushed[dof];
  const Eigen::VectorXd free = self.unknowns == 0 ? right : self.factor.solve(right);
  for (unsigned int dof = 0; dof < dofs; ++dof)
    if (self.unknown[dof] >= 0) answer[dof] = free[self.unknown[dof]];
  return answer;
}

Eigen::VectorXd Elasticity::free_part(Eigen::VectorXd nodal) const {
  for (std::size_t dof = 0; dof < implementation_->unknown.size(); ++dof)
    if (implementation_->unknown[dof] < 0) nodal[static_cast<Eigen::Index>(dof)] = 0;
  return nodal;
}

double Elasticity::round_off(const Eigen::VectorXd& displacements) const {
  return 10 * std::numeric_limits<double>::epsilon() *
         implementation_->largest_stiffness * displacements.norm();
}

}  // namespace springcheck::fem_reference
