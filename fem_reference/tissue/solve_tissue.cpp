#include "fem_reference/tissue/solve_tissue.hpp"

#include <cmath>

#include "fem_reference/laws/settings.hpp"
#include "fem_reference/statics/loads.hpp"
#include "fem_reference/tissue/tissue_cell.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::fem_reference {
namespace {

using Eigen::Index;

class RememberingElements final : public dynamics::RememberingBody {
 public:
  RememberingElements(const Mesh& mesh, const Scene& scene, const tissue::Solid& solid)
      : rest_(mesh.nodes()), solid_(solid), body_(discretise(mesh, Element::q1_sri)) {
    const Vector3 weight = scene.material.density * scene.gravity;
    load_ = body_load(body_, [&](const Vector3&) { return weight; });
    for (const Traction& traction : scene.tractions)
      load_ += traction_load(body_, traction);
    for (const Cell& cell : body_.cells) {
      first_.push_back(states_.size());
      states_.resize(states_.size() +
                     static_cast<std::size_t>(cell.shape->weights.size()) *
                         tissue::state_size(solid.shear.branches.size()));
    }
    first_.push_back(states_.size());
    tissue::set_to_rest(states_);
  }

  [[nodiscard]] std::vector<Vector3> load() const override {
    return statics::by_node(load_);
  }

  [[nodiscard]] statics::Patches patches() const override {
    return fem_reference::patches(body_);
  }

  [[nodiscard]] Forces forces_after(double dt,
                                    std::span<const Vector3> positions) override {
    const Eigen::VectorXd u = displacements(positions);
    const tissue::MemoryStep& step = step_of(dt);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(u.size());
    double squares = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      const Cell& cell = body_.cells[c];
      const TissueCellForces of = fem_reference::forces_after(
          {.solid = solid_, .step = step, .shape = *cell.shape, .states = states(c)},
          of_cell(u, cell));
      for (std::size_t a = 0; a < cell.nodes.size(); ++a)
        forces.segment<3>(static_cast<Index>(3 * cell.nodes[a])) -=
            of.forces.col(static_cast<Index>(a));
      squares += of.strand_square;
    }
    return {.on_nodes = statics::by_node(forces), .scale = std::sqrt(squares)};
  }

  void assemble_tangent(double dt, std::span<const Vector3> positions,
                        statics::BlockMatrix& sum) override {
    const Eigen::VectorXd u = displacements(positions);
    const tissue::MemoryStep& step = step_of(dt);
    sum.assemble([&](std::size_t c) {
      const Cell& cell = body_.cells[c];
      return tangent_after(
          {.solid = solid_, .step = step, .shape = *cell.shape, .states = states(c)},
          of_cell(u, cell));
    });
  }

  void advance(double dt, std::span<const Vector3> positions) override {
    const Eigen::VectorXd u = displacements(positions);
    for (std::size_t c = 0; c < body_.cells.size(); ++c)
      fem_reference::advance(solid_, step_of(dt), *body_.cells[c].shape,
                             std::span(states_).subspan(first_[c], states(c).size()),
                             of_cell(u, body_.cells[c]));
  }

  [[nodiscard]] double free_energy(std::span<const Vector3> positions) const override {
    const Eigen::VectorXd u = displacements(positions);
    double energy = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c)
      energy += fem_reference::free_energy(solid_, *body_.cells[c].shape, states(c),
                                           of_cell(u, body_.cells[c]));
    return energy;
  }

  [[nodiscard]] double largest_shear_strain(
      std::span<const Vector3> positions) const override {
    const Eigen::VectorXd u = displacements(positions);
    double largest = 0;
    for (const Cell& cell : body_.cells)
      largest = std::max(
          largest, fem_reference::largest_shear_strain(*cell.shape, of_cell(u, cell)));
    return largest;
  }

 private:
  [[nodiscard]] std::span<const double> states(std::size_t cell) const {
    return std::span(states_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

  [[nodiscard]] Eigen::VectorXd displacements(std::span<const Vector3> positions) const {
    return statics::stacked(positions) - statics::stacked(rest_);
  }

  const tissue::MemoryStep& step_of(double dt) {
    if (step_.duration != dt) step_ = tissue::memory_step(solid_, dt);
    return step_;
  }

  std::vector<Vector3> rest_;
  tissue::Solid solid_;
  Discretisation body_;
  Eigen::VectorXd load_;            // [N] at the full load
  std::vector<double> states_;      // of all Gauss points, cell by cell
  std::vector<std::size_t> first_;  // of each cell, and the end
  tissue::MemoryStep step_{.duration = 0};
};

}  // namespace

Solution solve_tissue(const Mesh& mesh, const Scene& scene, const tissue::Solid& solid,
                      const dynamics::QuasiStaticSettings& settings,
                      const dynamics::Observers& observers, const Stopwatch& setup) {
  RememberingElements elements(mesh, scene, solid);
  return dynamics::find_quasi_static(mesh, scene, elements, settings, observers, setup);
}

}  // namespace springcheck::fem_reference
