#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/quasi_static/remembering_body.hpp"
#include "meshing/loads/scene.hpp"
#include "meshing/mesh.hpp"
#include "statics/systems/system.hpp"

namespace springcheck::dynamics {

/// What a body in a scene is asked for: an equilibrium at the end of a step.
struct SoughtEquilibrium {
  double dt;                       // [s] of the step
  double load_fraction;            // at its end
  std::span<const Vector3> start;  // positions at its beginning [m]
  bool starts_definite;            // whether the tangent was, in the equilibrium there
};

struct FoundEquilibrium {
  std::vector<Vector3> positions;  // [m]
  bool is_definite;                // its tangent
  bool met_saddle;                 // it was found from a saddle, or is one
};

/// Finds equilibria of a body with memory by Newton's method, as find_quasi_static says.
/// Refers to what it is made of.
class EquilibriumSearch {
 public:
  EquilibriumSearch(const Mesh& mesh, const Scene& scene, RememberingBody& body);

  /// Nothing where none was found, or one on another branch (jumped).
  std::optional<FoundEquilibrium> find(const SoughtEquilibrium& sought);

  /// Whether the tangent at the end of a step is positive definite.
  bool is_definite(double dt, std::span<const Vector3> positions);

  /// How the last search ended: on another branch, and with that residual relative to the
  /// force scale.
  [[nodiscard]] bool jumped() const { return jumped_; }
  [[nodiscard]] double residual() const { return residual_; }

  [[nodiscard]] const std::vector<PrescribedComponent>& prescribed() const {
    return prescribed_;
  }
  [[nodiscard]] std::span<const Vector3> load() const { return load_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] int factorisations() const { return system_.factorisations().value(); }

 private:
  using Positions = std::vector<Vector3>;
  using Field = Eigen::VectorXd;  // an entry per free component, ascending

  [[nodiscard]] Field on_free(const std::vector<Vector3>& all) const;
  [[nodiscard]] Positions moved(Positions x, const Field& by, double factor) const;
  [[nodiscard]] double longest_way(const Field& change) const;
  [[nodiscard]] double largest_gradient(const Positions& from, const Positions& to) const;

  std::vector<Vector3> forces(double dt, const Positions& x, double load_fraction);
  bool linearise(double dt, std::span<const Vector3> positions);
  Field solve(const Field& forces);
  Positions predicted(const SoughtEquilibrium& sought);
  Field softest_mode();
  bool leave_saddle(const SoughtEquilibrium& sought, Positions& there, Field& residual);
  bool step(const SoughtEquilibrium& sought, bool buckles, Field change, Positions& there,
            Field& residual);

  const Mesh& mesh_;
  const Scene& scene_;
  RememberingBody& body_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<bool> is_free_;
  std::vector<Vector3> load_;  // [N] at the full load
  double cell_edge_;           // [m] mean
  statics::System system_;
  double force_scale_ = 0;  // [N] of the forces last asked for
  double residual_ = 0;
  bool jumped_ = false;
  int evaluations_ = 0;
};

}  // namespace springcheck::dynamics
