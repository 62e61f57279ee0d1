#pragma once

#include <span>
#include <vector>

#include "tissue/maxwell_branches.hpp"
#include "tissue/symmetric_tensor.hpp"

// A point of tissue in finite strain: the Maxwell model of simple shear, in terms of
// C = F^T F. Each branch remembers a tensor A_i, the elastic one's is I:
//
//     dA_i/dt = (C^-1 - A_i)/tau_i,                       A_i = I at rest
//     I_i = tr(C A_i) - 3 - ln det C,                     M_i of it as in BranchModuli
//     S = sum M_i A_i - eta d(C^-1)/dt                    second Piola-Kirchhoff [Pa]
//
// In simple shear I_i is <D^2>_i and sigma_xy = (F S F^T)_xy that of MaxwellModel, at any
// strain. At rest S = sum M_i I: the caller's volume force adds the pressure - sum M_i/J,
// which takes sum M_i C^-1 from S, makes rest free of stress, and is what the free energy
// below belongs to. F -> Q F leaves C, and so S, as they are.
//
// Made for motions that nearly keep their volume: I_i counts a lasting change of volume,
// as - ln det C in a branch that has relaxed. A compression so hardens a little, and an
// expansion would make I_i negative, which is taken as 0.
//
// Source: a network whose strands break and form anew at rest, Green and Tobolsky 1946,
// J. Chem. Phys. 14, 80, with a stiffness M_i that hardens as the bi-power law does.

namespace springcheck::tissue {

/// The state of a point, side by side: C^-1 of the last step, then A_1 to A_N. With five
/// branches 36 doubles, 288 bytes.
constexpr std::size_t state_size(std::size_t branches) {
  return 6 * (branches + 1);
}

void set_to_rest(std::span<double> state);

/// What a step of dt makes of a memory, C^-1 going straight from C_old^-1 to C_new^-1:
///
///     A <- e A + (1-e-f) C_old^-1 + f C_new^-1
///     e = exp(-dt/tau),  f = 1 - (1-e) tau/dt
struct Decay {
  double kept, from_old, from_new;  // e, 1-e-f, f; between 0 and 1
};
struct MemoryStep {
  double duration;            // dt [s]
  std::vector<Decay> decays;  // of each branch
};

/// Once for each dt > 0, not for each point. Throws InputError for a dt or a model that
/// cannot be.
MemoryStep memory_step(const MaxwellModel& model, double duration);

struct PointStress {
  SymmetricTensor second_piola_kirchhoff;  // S [Pa], without the pressure
  double stiffness_sum;                    // sum M_i [Pa]
};

/// At the end of a step that leads to C, with -eta (C_new^-1 - C_old^-1)/dt for the
/// dashpot: the branches are of second order in dt, the dashpot of first (exact in a
/// simple shear at constant rate). C is positive definite; the state is that before the
/// step and stays so.
PointStress stress_after(const MaxwellModel& model, const MemoryStep& step,
                         std::span<const double> state, const SymmetricTensor& C);

/// The same, and the state becomes that after the step.
PointStress advance(const MaxwellModel& model, const MemoryStep& step,
                    std::span<double> state, const SymmetricTensor& C);

/// The same for many points, whose states follow each other.
void advance(const MaxwellModel& model, const MemoryStep& step, std::span<double> states,
             std::span<const SymmetricTensor> C, std::span<PointStress> stresses);

/// Derivatives of stress_after by the six entries of C; the two places of an entry off
/// the diagonal change together.
///
///     dS/dC : H = sum A_i (dM_i/dC : H) - (sum f_i M_i - eta/dt) C^-1 H C^-1
///     dM_i/dC   = M_i' (A_i - (1 + f_i) C^-1)
///
/// The matrix is not symmetric: M_i depends on C by its memory too. With the pressure,
/// A_i - C^-1 replaces A_i, and it still is not, by f_i.
struct PointTangent {
  Eigen::Matrix<double, 6, 6> stress;  // dS/dC [Pa]
  SymmetricTensor stiffness_sum;       // d(sum M_i)/dC [Pa]
};
PointTangent tangent_after(const MaxwellModel& model, const MemoryStep& step,
                           std::span<const double> state, const SymmetricTensor& C);

}  // namespace springcheck::tissue
