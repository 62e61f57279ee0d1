#include "mss/tissue/thesis_springs.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/basics/stopwatch.hpp"
#include "meshing/loads/traction.hpp"
#include "mss/forces/forces.hpp"
#include "mss/forces/tangent.hpp"
#include "statics/systems/block_matrix.hpp"

namespace springcheck::mss {
namespace {

/// The network's cells with the volume correction alone.
Network without_springs(const Network& network) {
  Network left{.rest_positions = network.rest_positions,
               .volume_moduli = network.volume_moduli,
               .masses = network.masses};
  for (std::size_t c = 0; c < network.cells.size(); ++c)
    left.cells.add(network.cells.nodes(c), network.cells.gradients(c),
                   network.cells.volume(c), {});
  return left;
}

class ThesisSprings final : public dynamics::RememberingBody {
 public:
  ThesisSprings(const Mesh& mesh, const Scene& scene, Network network,
                const tissue::ThesisSpring& spring)
      : network_(std::move(network)),
        volumes_(without_springs(network_)),
        spring_(spring),
        load_(load_forces(mesh, scene, network_.masses)) {}

  [[nodiscard]] std::vector<Vector3> load() const override { return load_; }

  [[nodiscard]] statics::Patches patches() const override {
    return mss::patches(volumes_);
  }

  /// Measured by the largest tensions in an equilibrium so far: they all vanish where the
  /// body comes back to rest.
  [[nodiscard]] Forces forces_after(double, std::span<const Vector3> positions) override {
    std::vector<Vector3> forces(positions.size());
    nodal_forces(volumes_, positions, forces);
    double squares = 0;
    for (const Spring& spring : network_.springs) {
      const Vector3 d = positions[spring.b] - positions[spring.a];
      const double length = d.norm();
      const double pull = tension(spring_, spring.stiffness, spring.rest_length, length);
      squares += pull * pull;
      if (length == 0) continue;
      forces[spring.a] += pull / length * d;
      forces[spring.b] -= pull / length * d;
    }
    tensions_ = std::sqrt(squares);
    return {.on_nodes = std::move(forces), .scale = std::max(largest_, tensions_)};
  }

  void assemble_tangent(double, std::span<const Vector3> positions,
                        statics::BlockMatrix& sum) override {
    const Tangent tangent = tangent_at(volumes_, positions);
    sum.assemble([&](std::size_t cell) {
      Eigen::MatrixXd matrix = part(tangent, cell);
      add_springs(cell, positions, matrix);
      return matrix;
    });
  }

  void advance(double, std::span<const Vector3>) override {
    largest_ = std::max(largest_, tensions_);
  }

  [[nodiscard]] double free_energy(std::span<const Vector3> positions) const override {
    double energy = strain_energy(volumes_, positions);
    for (const Spring& spring : network_.springs)
      energy += stored_energy(spring_, spring.stiffness, spring.rest_length,
                              (positions[spring.b] - positions[spring.a]).norm());
    return energy;
  }

  [[nodiscard]] double largest_shear_strain(
      std::span<const Vector3> positions) const override {
    std::vector<Vector3> displacements(positions.begin(), positions.end());
    for (std::size_t n = 0; n < displacements.size(); ++n)
      displacements[n] -= network_.rest_positions[n];
    double largest = 0;
    for (std::size_t c = 0; c < network_.cells.size(); ++c) {
      const Matrix3 F =
          Matrix3::Identity() + network_.cells.displacement_gradient(c, displacements);
      const double volume = std::abs(F.determinant());
      largest = std::max(largest, F.squaredNorm() / std::pow(volume, 2. / 3) - 3);
    }
    return std::sqrt(std::max(largest, 0.));
  }

 private:
  /// T' n n^T + T/|d| (I - n n^T) of a cell's springs.
  void add_springs(std::size_t cell, std::span<const Vector3> positions,
                   Eigen::MatrixXd& matrix) const {
    const auto nodes = network_.cells.nodes(cell);
    for (const auto& [ends, stiffness, rest] : network_.cells.springs(cell)) {
      const Vector3 d = positions[nodes[ends[1]]] - positions[nodes[ends[0]]];
      const double length = d.norm(), rest_length = rest.norm();
      if (length == 0) continue;
      const Matrix3 along = d * d.transpose() / (length * length);
      const Matrix3 block =
          tangent_stiffness(spring_, stiffness, rest_length, length) * along +
          tension(spring_, stiffness, rest_length, length) / length *
              (Matrix3::Identity() - along);
      add_between(matrix, ends, block);
    }
  }

  Network network_, volumes_;
  tissue::ThesisSpring spring_;
  std::vector<Vector3> load_;          // [N] at the full load
  double tensions_ = 0, largest_ = 0;  // [N], their norm, and in equilibria so far
};

}  // namespace

Solution move_thesis_springs(const Mesh& mesh, const Scene& scene,
                             const tissue::ThesisSpring& spring,
                             const dynamics::QuasiStaticSettings& settings,
                             const dynamics::Observers& observers) {
  Material material = scene.material;
  material.young_modulus = spring.law.consistency;
  if (const auto reason = reason_to_refuse(mesh, material, SpringModel::cf))
    return refused(*reason);
  const Stopwatch setup;
  ThesisSprings springs(mesh, scene,
                        build_network(mesh, material,
                                      {.model = SpringModel::cf,
                                       .stiffness_form = StiffnessForm::shear_modulus,
                                       .diagonal_ratio = 1}),
                        spring);
  return dynamics::find_quasi_static(mesh, scene, springs, settings, observers, setup);
}

}  // namespace springcheck::mss
