#pragma once

#include <span>
#include <vector>

#include "tissue/solid.hpp"
#include "tissue/symmetric_tensor.hpp"

// A point of tissue in finite strain: the Maxwell model of simple shear, in terms of
// C = F^T F without its change of volume,
//
//     C' = C/J^(2/3),   J = sqrt(det C),   det C' = 1
//
// Each branch remembers a tensor A_i, the elastic one's is I:
//
//     dA_i/dt = (C'^-1 - A_i)/tau_i,              A_i = I at rest
//     I_i = tr(C' A_i) - 3,                       M_i, as in BranchModuli, of
//                                                 I_i + r (J-1)^2
//     S = sum M_i A_i/J^(2/3) - eta d(C^-1)/dt + J v C^-1
//                                                 second Piola-Kirchhoff [Pa]
//     v = sum M_i {r (J-1) - (1 + I_i/3)/J}       what resists a growth of volume [Pa]
//
// In simple shear I_i is <D^2>_i and sigma_xy = (F S F^T)_xy that of MaxwellModel, at any
// strain. Rest is free of stress, and a sudden small strain meets the shear modulus
// sum M_i and the bulk modulus r sum M_i, which follows the hardening. F -> Q F leaves C,
// and so S, as they are.
//
// No motion makes such a point give off energy. A_i is a mean of tensors of determinant 1
// over the past: as det^(1/3) is concave, det A_i >= 1, and so tr(C' A_i) >= 3
// det(C' A_i)^(1/3) >= 3, that is, I_i >= 0. S is 2 dpsi/dC and the dashpot's part, of
//
//     psi = 1/2 sum W_i(I_i + r (J-1)^2),         W_i' = M_i
//
// as dI_i/dC at fixed A_i is A_i/J^(2/3) - (1 + I_i/3) C^-1; and what psi loses as A_i
// fades is M_i I_i/(2 tau_i). Were A_i to follow C^-1 itself, or kappa = r sum M_i to
// follow a hardening that leaves the change of volume out, neither would hold.
//
// Source: a network whose strands break and form anew at rest, Green and Tobolsky 1946,
// J. Chem. Phys. 14, 80, with a stiffness M_i that hardens as the bi-power law does, and
// the volume-preserving part C' as Simo 1987, Comput. Methods Appl. Mech. Eng. 60, 153.

namespace springcheck::tissue {

/// The state of a point, side by side: C^-1 of the last step, then A_1 to A_N. With five
/// branches 36 doubles, 288 bytes.
constexpr std::size_t state_size(std::size_t branches) {
  return 6 * (branches + 1);
}

void set_to_rest(std::span<double> state);

/// What a step of dt makes of a memory, C'^-1 going straight from old to new:
///
///     A <- e A + (1-e-f) C'_old^-1 + f C'_new^-1
///     e = exp(-dt/tau),  f = 1 - (1-e) tau/dt
struct Decay {
  double kept, from_old, from_new;  // e, 1-e-f, f; between 0 and 1
};
struct MemoryStep {
  double duration;              // dt [s]
  std::vector<Decay> decays{};  // of each branch
};

/// The step's numbers, to be made once for each dt > 0, not for each point. Throws
/// InputError for a dt or a solid that cannot be.
MemoryStep memory_step(const Solid& solid, double duration);

/// The same with C'^-1 new from the step's start: A <- e A + (1-e) C'_new^-1. It is of
/// first order, half a step ahead: for explicit steps, which no motion of tissue moves
/// far.
MemoryStep short_memory_step(const Solid& solid, double duration);

/// S in the two parts that springs and the volume force carry.
struct PointStress {
  SymmetricTensor strands;  // sum M_i A_i/J^(2/3) and the dashpot's [Pa]
  double volume;            // v [Pa]
};

/// S [Pa], its parts put together.
SymmetricTensor second_piola_kirchhoff(const PointStress& stress,
                                       const SymmetricTensor& C);

/// The stress at the end of a step that leads to C, with -eta (C_new^-1 - C_old^-1)/dt
/// for the dashpot: the branches are of second order in dt, the dashpot of first (exact
/// in a simple shear at constant rate). C is positive definite; the state is that before
/// the step and stays so.
PointStress stress_after(const Solid& solid, const MemoryStep& step,
                         std::span<const double> state, const SymmetricTensor& C);

/// The stress at C, which changes at the rate dC/dt [1/s], with the memories as they are:
/// what a sudden change of C or of its rate meets. The dashpot has eta C^-1 dC/dt C^-1.
PointStress stress_at(const Solid& solid, std::span<const double> state,
                      const SymmetricTensor& C, const SymmetricTensor& rate);

/// Returns stress_after, and makes the state that after the step.
PointStress advance(const Solid& solid, const MemoryStep& step, std::span<double> state,
                    const SymmetricTensor& C);

/// The same for many points, whose states follow each other.
void advance(const Solid& solid, const MemoryStep& step, std::span<double> states,
             std::span<const SymmetricTensor> C, std::span<PointStress> stresses);

/// Derivatives of stress_after by the six entries of C; the two places of an entry off
/// the diagonal change together. With D_i = A_i/J^(2/3) - (1 + I_i/3) C^-1 and
/// Q_i = D_i + r (J-1) J C^-1, the derivatives of M_i's two arguments,
///
///     d strands : H = sum {M_i' (Q_i : H) - M_i/3 C^-1 : H} A_i/J^(2/3)
///                     + sum f_i M_i {(C^-1 : H) C^-1/3 - C^-1 H C^-1}
///                     + eta/dt C^-1 H C^-1
///     d volume      = sum M_i' {r (J-1) - (1 + I_i/3)/J} Q_i
///                     + sum M_i {(r J + (1 + I_i/3)/J)/2 C^-1 - D_i/(3 J)}
///
/// Put together as S they are symmetric: the C'^-1 that a step adds to A_i does not
/// change I_i.
struct PointTangent {
  Eigen::Matrix<double, 6, 6> strands;  // [Pa]
  SymmetricTensor volume;               // [Pa]
};
PointTangent tangent_after(const Solid& solid, const MemoryStep& step,
                           std::span<const double> state, const SymmetricTensor& C);

}  // namespace springcheck::tissue
