#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fem_reference/cells/discretisation.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/loads/scene.hpp"

// Meshes, fields and scenes that several tests of the solver are made from.
namespace springcheck::fem_reference {

inline constexpr double edge = 0.05;  // m, the cube's

inline constexpr Element elements[] = {Element::q1, Element::q1_sri, Element::q1_nodal,
                                       Element::q2};

/// The patterns of all cell types, one each and together.
inline constexpr CellPattern patterns[] = {CellPattern::hexahedron,
                                           CellPattern::tetrahedron, CellPattern::prism,
                                           CellPattern::pyramid, CellPattern::mixed};

/// The elements there are on a pattern's cells.
inline std::span<const Element> elements_on(CellPattern pattern) {
  return std::span(elements).first(pattern == CellPattern::hexahedron ? 4 : 3);
}

inline constexpr Law laws[] = {Law::hooke, Law::st_venant_kirchhoff, Law::hencky,
                               Law::cauchy_born};

inline std::string words(Law law) {
  constexpr const char* names[] = {"hooke", "st-venant", "hencky", "cauchy-born"};
  return names[static_cast<int>(law)];
}

inline std::string words(Element element) {
  constexpr const char* names[] = {"q1", "q1-sri", "q1-nodal", "q2"};
  return names[static_cast<int>(element)];
}

inline std::string words(CellPattern pattern) {
  return std::string(cell_patterns()[static_cast<std::size_t>(pattern)].name);
}

/// A cube whose nodes inside are moved by up to the distortion times the cells' edge.
inline Mesh cube(int cells, CellPattern pattern = CellPattern::hexahedron,
                 double distortion = 0) {
  return generate_block({.size = {edge, edge, edge},
                         .cells = {cells, cells, cells},
                         .pattern = pattern,
                         .distortion = distortion});
}

/// The mesh with its nodes moved, cells and regions as they were.
inline Mesh mapped(const Mesh& mesh, const std::function<Vector3(const Vector3&)>& map) {
  std::vector<Vector3> nodes;
  for (const Vector3& x : mesh.nodes()) nodes.push_back(map(x));
  std::map<std::string, std::vector<FaceNodes>> regions;
  for (const auto& [name, region] : mesh.regions()) regions[name] = region.faces;
  return {"mapped " + mesh.source(), nodes, mesh.cells(), regions};
}

/// The mesh with its nodes numbered at random.
inline Mesh renumbered(const Mesh& mesh) {
  std::vector<NodeIndex> number(mesh.nodes().size());
  std::iota(number.begin(), number.end(), NodeIndex{0});
  std::ranges::shuffle(number, std::mt19937(5));
  std::vector<Vector3> nodes(number.size());
  for (std::size_t node = 0; node < number.size(); ++node)
    nodes[number[node]] = mesh.nodes()[node];
  const auto renumber = [&](auto corners) {
    for (NodeIndex& node : corners) node = number[node];
    return corners;
  };
  std::vector<CellNodes> cells;
  for (const CellNodes& cell : mesh.cells()) cells.push_back(renumber(cell));
  std::map<std::string, std::vector<FaceNodes>> regions;
  for (const auto& [name, region] : mesh.regions())
    for (const FaceNodes& face : region.faces) regions[name].push_back(renumber(face));
  return {"renumbered " + mesh.source(), nodes, cells, regions};
}

/// Components uniform in [-size, size].
class RandomVectors {
 public:
  RandomVectors(double size, unsigned seed) : component_(-size, size), random_(seed) {}
  Vector3 operator()() {
    const double x = component_(random_), y = component_(random_),
                 z = component_(random_);
    return {x, y, z};
  }

 private:
  std::uniform_real_distribution<double> component_;
  std::mt19937 random_;
};

inline bool on_cubes_boundary(const Vector3& x) {
  return x.minCoeff() < 1e-9 || x.maxCoeff() > edge - 1e-9;
}

enum class Moved { interior_nodes, all_nodes };

/// Nodes moved by up to `amount` of the cells' edge in each component.
inline Mesh distorted_cube(int cells, double amount, Moved moved) {
  RandomVectors move(amount * edge / cells, 7);
  return mapped(cube(cells), [&](const Vector3& x) -> Vector3 {
    const Vector3 by = move();
    return moved == Moved::interior_nodes && on_cubes_boundary(x) ? x : x + by;
  });
}

/// Cells of irregular shape in a body with curved sides: no quadrilateral is plane.
inline Mesh warped_cube(int cells, CellPattern pattern) {
  return mapped(cube(cells, pattern, 0.2), [&](const Vector3& x) -> Vector3 {
    const Vector3 wave = (4 / edge * x).array().sin();
    return x + 0.08 * edge / cells * Vector3(wave.y() + wave.z(), wave.z(), wave.x());
  });
}

/// Values of a field at all nodes, dof = 3 node + component.
inline Eigen::VectorXd nodal(const Discretisation& body,
                             const std::function<Vector3(const Vector3&)>& field) {
  Eigen::VectorXd values(3 * static_cast<Eigen::Index>(body.nodes.size()));
  for (std::size_t node = 0; node < body.nodes.size(); ++node)
    values.segment<3>(static_cast<Eigen::Index>(3 * node)) = field(body.nodes[node]);
  return values;
}

inline Eigen::VectorXd random_nodal(const Discretisation& body, double size,
                                    unsigned seed = 11) {
  RandomVectors random(size, seed);
  return nodal(body, [&](const Vector3&) { return random(); });
}

/// Sum of the cells' tangents, prescribed dofs like all others.
inline Eigen::MatrixXd dense_tangent(const Discretisation& body, const CellLaw& law,
                                     const Eigen::VectorXd& u) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(u.size(), u.size());
  for (const Cell& cell : body.cells) {
    const CellMatrix K = cell_tangent(law, *cell.shape, of_cell(u, cell));
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      for (std::size_t b = 0; b < cell.nodes.size(); ++b)
        sum.block<3, 3>(3 * cell.nodes[a], 3 * cell.nodes[b]) += K.block<3, 3>(
            static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
  }
  return sum;
}

/// Rows and columns of the free dofs.
inline Eigen::MatrixXd free_block(const Eigen::MatrixXd& matrix,
                                  const std::vector<bool>& is_free) {
  std::vector<Eigen::Index> dofs;
  for (std::size_t dof = 0; dof < is_free.size(); ++dof)
    if (is_free[dof]) dofs.push_back(static_cast<Eigen::Index>(dof));
  return matrix(dofs, dofs);
}

inline RigidMotion translation(const Vector3& by) {
  return {
      .translation = by, .axis = Vector3::UnitZ(), .centre = Vector3::Zero(), .angle = 0};
}

inline Plate plate(std::string region, const RigidMotion& motion,
                   const Held& held = all_components) {
  return {.region = std::move(region), .motion = motion, .held = held};
}

inline Plate fixed(std::string region) {
  return plate(std::move(region), translation(Vector3::Zero()));
}

/// A body glued to a fixed plate at the bottom and a moved one at the top, that turns
/// about the cube's axis.
inline Scene between_plates(const Material& material, const Vector3& top_translation,
                            double top_angle = 0) {
  return {.material = material,
          .plates = {fixed("bottom"),
                     plate("top", {.translation = top_translation,
                                   .axis = Vector3::UnitZ(),
                                   .centre = Vector3(edge / 2, edge / 2, edge),
                                   .angle = top_angle})},
          .gravity = Vector3::Zero()};
}

inline Vector3 total(const std::vector<Vector3>& vectors) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& v : vectors) sum += v;
  return sum;
}

inline Vector3 total(const Eigen::VectorXd& nodal_vectors) {
  return nodal_vectors.reshaped(3, nodal_vectors.size() / 3).rowwise().sum();
}

}  // namespace springcheck::fem_reference
