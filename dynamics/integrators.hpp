#pragma once

namespace springcheck::dynamics {

/// Ways to step x' = v, v' = a(x, v); n counts steps of dt:
///
///     explicit Euler        x_n+1 = x_n + dt v_n,  v_n+1 = v_n + dt a(x_n, v_n)
///     semi-implicit Euler   v_n+1 = v_n + dt a(x_n, v_n),  x_n+1 = x_n + dt v_n+1
///     Verlet                v_n+1/2 = v_n-1/2 + dt a(x_n, v_n-1/2),
///                           x_n+1 = x_n + dt v_n+1/2,  v_1/2 = v_0 + dt/2 a(x_0, v_0)
///     implicit Euler        v_n+1 = v_n + dt a(x_n+1, v_n+1),  x_n+1 = x_n + dt v_n+1
///
/// Verlet's positions are those of x_n+1 = 2 x_n - x_n-1 + dt^2 a_n where a does not
/// depend on v; with dashpots it takes the velocities half a step late, and is of first
/// order in them.
/// Source: Golec 2018, Eq. 2.14, 2.15, 2.25 with 2.26, and 2.16; f there is f/m.
enum class Integrator { explicit_euler, semi_implicit_euler, verlet, implicit_euler };

/// One step of the explicit ones on any numbers or packs of them. `kick` is dt, but for
/// Verlet's first step dt/2.
template <class Number, class Real>
inline void step(Integrator integrator, Number& x, Number& v, const Number& acceleration,
                 Real dt, Real kick) {
  if (integrator == Integrator::explicit_euler) x += dt * v;
  v += kick * acceleration;
  if (integrator != Integrator::explicit_euler) x += dt * v;
}

}  // namespace springcheck::dynamics
