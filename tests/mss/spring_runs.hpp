#pragma once

#include <optional>
#include <vector>

#include "mss/motion/dynamics.hpp"
#include "tests/mss/blocks.hpp"

// What several tests of the springs' dynamics are made from.
namespace springcheck::mss {

struct NamedIntegrator {
  const char* name;
  dynamics::Integrator integrator;
};
inline constexpr NamedIntegrator explicit_integrators[] = {
    {"explicit", dynamics::Integrator::explicit_euler},
    {"semi-implicit", dynamics::Integrator::semi_implicit_euler},
    {"verlet", dynamics::Integrator::verlet}};
inline constexpr NamedIntegrator all_integrators[] = {
    explicit_integrators[0],
    explicit_integrators[1],
    explicit_integrators[2],
    {"implicit", dynamics::Integrator::implicit_euler}};

inline Material tissue_of(double nu) {
  return {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000};
}

/// No step: of the dynamics' own choice.
inline DynamicsSettings settings_of(dynamics::Integrator integrator, double duration,
                                    std::optional<double> time_step,
                                    double damping_ratio) {
  return {.protocol = {.integrator = integrator,
                       .duration = duration,
                       .time_step = time_step,
                       .force_time_step = false},
          .damping_ratio = damping_ratio};
}

/// A mesh between glued plates, the upper of which moves by `way`.
inline Scene between_plates(const Material& material, const Vector3& way) {
  return {.material = material,
          .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                     {"top", translation(way), all_components}},
          .gravity = Vector3::Zero()};
}

/// A body that nothing holds, nor pulls.
inline Scene in_free_space(const Material& material) {
  return {.material = material, .plates = {}, .gravity = Vector3::Zero()};
}

/// Steps of dt where supports stay and loads are none, from the first.
inline void let_go(dynamics::Motion& motion, const Scene& scene,
                   dynamics::Integrator integrator, double dt, int steps) {
  const auto still = dynamics::support_motions(scene, 0);
  for (int n = 0; n < steps; ++n)
    motion.advance(
        {.dt = dt,
         .kick = n == 0 && integrator == dynamics::Integrator::verlet ? dt / 2 : dt,
         .load_fraction = 0,
         .motions_before = still,
         .motions = still});
}

}  // namespace springcheck::mss
