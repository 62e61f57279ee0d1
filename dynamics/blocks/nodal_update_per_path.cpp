// Compiled once per instruction set.
#include "dynamics/blocks/nodal_update_paths.hpp"
#include "dynamics/blocks/pack.hpp"

namespace springcheck::dynamics::SPRINGCHECK_PATH {
namespace {

template <class Real>
void update(const BlockArrays<Real>& arrays, const NodalStep& now) {
  const auto dt = static_cast<Real>(now.dt), kick = static_cast<Real>(now.kick),
             fraction = static_cast<Real>(now.load_fraction);
  const std::size_t slots = arrays.rows * arrays.lanes;
  for (std::size_t s = 0; s < slots; s += width<Real>) {
    const Pack<Real> inverse_mass = load(arrays.inverse_mass + s);
    for (std::size_t i = 0; i < 3; ++i) {
      Pack<Real> force = load(arrays.force[i] + s);
      if (arrays.load[i] != nullptr) force += fraction * load(arrays.load[i] + s);
      Pack<Real> u = load(arrays.displacement[i] + s), v = load(arrays.velocity[i] + s);
      const Pack<Real> acceleration = inverse_mass * force;
      step(now.integrator, u, v, acceleration, dt, kick);
      store(arrays.displacement[i] + s, u);
      store(arrays.velocity[i] + s, v);
    }
  }
}

}  // namespace

NodalUpdate<double> update_of_nodes(double) {
  return update<double>;
}
NodalUpdate<float> update_of_nodes(float) {
  return update<float>;
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
