#pragma once

#include "tissue/memory.hpp"

namespace springcheck::tissue {

/// Free energy of a point at C with the memories of `state` [J/m^3]:
///
///     psi = 1/2 sum W_i(I_i + r (J-1)^2),  W_i' = M_i
///
/// 2 dpsi/dC is S without the dashpot. 0 at rest and positive elsewhere.
double free_energy(const Solid& solid, std::span<const double> state,
                   const SymmetricTensor& C);

/// Power that a point turns into heat at the end of a step [W/m^3], `before` and `after`
/// its states:
///
///     sum M_i I_i/(2 tau_i) - eta/2 (C_new^-1 - C_old^-1)/dt : (C_new - C_old)/dt
///
/// that is, - sum dpsi/dA_i : dA_i/dt and the dashpot's work. Never negative: I_i >= 0,
/// see memory.hpp, and the inverse of a positive tensor falls as the tensor grows.
double dissipation(const Solid& solid, const MemoryStep& step,
                   std::span<const double> before, std::span<const double> after);

}  // namespace springcheck::tissue
