#include "mss/tissue/quasi_static.hpp"

#include <cmath>

#include "meshing/loads/traction.hpp"
#include "statics/systems/block_matrix.hpp"

namespace springcheck::mss {
namespace {

class RememberingTissue final : public dynamics::RememberingBody {
 public:
  RememberingTissue(const Mesh& mesh, const Scene& scene, const TissueBody& body)
      : body_(body),
        load_(load_forces(mesh, scene, body.masses)),
        memories_(memories_at_rest(body)),
        stresses_(body.cells.size()) {}

  [[nodiscard]] std::vector<Vector3> load() const override { return load_; }

  [[nodiscard]] statics::Patches patches() const override {
    statics::Patches patches;
    for (const CellNodes& cell : body_.cells)
      patches.emplace_back(cell.begin(), cell.end());
    return patches;
  }

  [[nodiscard]] Forces forces_after(double dt,
                                    std::span<const Vector3> positions) override {
    stresses_after(body_, step_of(dt), memories_, positions, stresses_);
    std::vector<Vector3> forces(positions.size());
    nodal_forces(body_, stresses_, positions, forces);
    double squares = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c)
      squares += tissue_forces(body_.shape(c), positions_of(body_, c, positions),
                               {stresses_[c].strands, 0})
                     .squaredNorm();
    return {.on_nodes = std::move(forces), .scale = std::sqrt(squares)};
  }

  void assemble_tangent(double dt, std::span<const Vector3> positions,
                        statics::BlockMatrix& sum) override {
    const tissue::MemoryStep& step = step_of(dt);
    const std::size_t size = tissue::state_size(body_.solid.shear.branches.size());
    sum.assemble([&](std::size_t c) -> Eigen::MatrixXd {
      const CornerPositions at = positions_of(body_, c, positions);
      const tissue::PointTangent tangent = tissue::tangent_after(
          body_.solid, step, std::span(memories_).subspan(c * size, size),
          right_cauchy_green(body_.shape(c), at));
      const TissueStiffness K =
          tissue_stiffness(body_.shape(c), at, stresses_[c], tangent);
      return (K + K.transpose()) / 2;
    });
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

 private:
  const tissue::MemoryStep& step_of(double dt) {
    if (step_.duration != dt) step_ = tissue::memory_step(body_.solid, dt);
    return step_;
  }

  const TissueBody& body_;
  std::vector<Vector3> load_;  // [N] at the full load
  std::vector<double> memories_;
  std::vector<tissue::PointStress> stresses_;
  tissue::MemoryStep step_{.duration = 0};
};

}  // namespace

Solution find_quasi_static(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const dynamics::QuasiStaticSettings& settings,
                           const dynamics::Observers& observers, const Stopwatch& setup) {
  RememberingTissue tissue(mesh, scene, body);
  return dynamics::find_quasi_static(mesh, scene, tissue, settings, observers, setup);
}

}  // namespace springcheck::mss
