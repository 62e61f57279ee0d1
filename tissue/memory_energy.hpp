#pragma once

#include "tissue/memory.hpp"

namespace springcheck::tissue {

/// Free energy of a point at C with the memories of `state` [J/m^3]:
///
///     psi = 1/2 sum {W_i(I_i) - G_i ln det A_i},  W_i' = M_i
///
/// 2 dpsi/dC = sum M_i (A_i - C^-1): S with the pressure - sum M_i/J, without the
/// dashpot. 0 at rest.
double free_energy(const MaxwellModel& model, std::span<const double> state,
                   const SymmetricTensor& C);

/// Power that a point turns into heat at the end of a step [W/m^3], `before` and `after`
/// its states:
///
///     sum {M_i (tr C A_i - 3) + G_i (tr (C A_i)^-1 - 3)}/(2 tau_i)
///         - eta/2 (C_new^-1 - C_old^-1)/dt : (C_new - C_old)/dt
///
/// that is, - sum dpsi/dA_i : dA_i/dt and the dashpot's work. Never negative where the
/// volume is kept, as then det (C A_i) >= 1. Where it is not, G_i's part and the
/// dashpot's still are not, but B_i's can be: I_i has ln det C for ln det (C A_i). A
/// percent of volume is enough where strains are smaller than that.
double dissipation(const MaxwellModel& model, const MemoryStep& step,
                   std::span<const double> before, std::span<const double> after);

}  // namespace springcheck::tissue
