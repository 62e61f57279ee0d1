#include "mss/tissue/quasi_static.hpp"

#include <cmath>

#include "meshing/stopwatch.hpp"
#include "meshing/traction.hpp"
#include "mss/statics/direct_solver.hpp"

namespace springcheck::mss {
namespace {

using Eigen::Index;

/// The cells as patches of a tangent, without anything that acts.
Network patches_of(const TissueBody& body) {
  Network network{.rest_positions = body.rest_positions, .masses = body.masses};
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellNodes& cell = body.cells[c];
    const std::vector<Vector3> no_gradients(cell.size(), Vector3::Zero());
    network.cells.add(std::span(cell.begin(), cell.end()), no_gradients,
                      body.shape(c).volume, {});
  }
  return network;
}

class RememberingTissue final : public dynamics::RememberingBody {
 public:
  RememberingTissue(const Mesh& mesh, const Scene& scene, const TissueBody& body)
      : body_(body),
        load_(traction_forces(mesh, scene)),
        solver_(patches_of(body),
                free_components(mesh, prescribed_components(mesh, scene))),
        memories_(memories_at_rest(body)),
        stresses_(body.cells.size()) {
    for (std::size_t n = 0; n < load_.size(); ++n)
      load_[n] += body.masses[n] * scene.gravity;
    tangent_.cells.resize(body.cells.size());
  }

  [[nodiscard]] std::vector<Vector3> load() const override { return load_; }

  [[nodiscard]] std::vector<Vector3> forces_after(
      double dt, std::span<const Vector3> positions) override {
    stresses_after(body_, step_of(dt), memories_, positions, stresses_);
    std::vector<Vector3> forces(positions.size());
    nodal_forces(body_, stresses_, positions, forces);
    double squares = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c)
      squares += tissue_forces(body_.shape(c), positions_of(body_, c, positions),
                               {stresses_[c].strands, 0})
                     .squaredNorm();
    force_scale_ = std::sqrt(squares);
    return forces;
  }

  [[nodiscard]] double force_scale() const override { return force_scale_; }

  bool linearise(double dt, std::span<const Vector3> positions) override {
    const tissue::MemoryStep& step = step_of(dt);
    const std::size_t size = tissue::state_size(body_.solid.shear.branches.size());
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      const CornerPositions at = positions_of(body_, c, positions);
      const tissue::PointTangent tangent = tissue::tangent_after(
          body_.solid, step, std::span(memories_).subspan(c * size, size),
          right_cauchy_green(body_.shape(c), at));
      const TissueStiffness K =
          tissue_stiffness(body_.shape(c), at, stresses_[c], tangent);
      tangent_.cells[c] = (K + K.transpose()) / 2;
    }
    solver_.prepare(tangent_);
    const bool is_definite = solver_.is_definite();
    if (!is_definite) solver_.prepare_clamped(tangent_);
    return is_definite;
  }

  [[nodiscard]] std::vector<Vector3> stiffness_times(
      std::span<const Vector3> displacements) const override {
    std::vector<Vector3> result(displacements.size(), Vector3::Zero());
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      const CornerPositions moves = positions_of(body_, c, displacements);
      const Eigen::VectorXd f = tangent_.cells[c] * moves.reshaped();
      for (std::size_t a = 0; a < body_.cells[c].size(); ++a)
        result[body_.cells[c][a]] += f.segment<3>(static_cast<Index>(3 * a));
    }
    return result;
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& forces) override {
    return solver_.solve(forces).value();
  }

  void advance(double dt, std::span<const Vector3> positions) override {
    mss::advance(body_, step_of(dt), memories_, positions, stresses_);
  }

  [[nodiscard]] double free_energy(std::span<const Vector3> positions) const override {
    return mss::free_energy(body_, memories_, positions);
  }

  [[nodiscard]] double largest_shear_strain(
      std::span<const Vector3> positions) const override {
    return mss::largest_shear_strain(body_, positions);
  }

  [[nodiscard]] int factorisations() const override { return solver_.factorisations(); }

 private:
  const tissue::MemoryStep& step_of(double dt) {
    if (step_.duration != dt) step_ = tissue::memory_step(body_.solid, dt);
    return step_;
  }

  const TissueBody& body_;
  std::vector<Vector3> load_;  // [N] at the full load
  DirectSolver solver_;
  Tangent tangent_;
  std::vector<double> memories_;
  std::vector<tissue::PointStress> stresses_;
  tissue::MemoryStep step_{.duration = 0};
  double force_scale_ = 0;
};

}  // namespace

Solution find_quasi_static(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const dynamics::QuasiStaticSettings& settings,
                           const dynamics::Observers& observers) {
  const Stopwatch stopwatch;
  RememberingTissue tissue(mesh, scene, body);
  const double setup_wall_s = stopwatch.seconds();
  Solution solution =
      dynamics::find_quasi_static(mesh, scene, tissue, settings, observers);
  solution.setup_wall_s += setup_wall_s;
  return solution;
}

}  // namespace springcheck::mss
