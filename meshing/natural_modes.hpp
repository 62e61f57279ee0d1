#pragma once

#include <Eigen/SparseCore>
#include <optional>

namespace springcheck {

/// Small free vibrations of a body at rest.
struct NaturalModes {
  // Shapes that no force resists: six of a free body, fewer where it is held, more where
  // springs leave other motions free. Beyond twelve some may be missed.
  int zero_modes;
  Eigen::VectorXd frequencies;  // f = omega/(2 pi) [Hz] of the others, ascending
  Eigen::MatrixXd shapes;       // their x as columns, x_i . M x_j = delta_ij [1/sqrt(kg)]
};

/// The lowest `count` natural modes, or as many as there are, of
///
///     K x = omega^2 M x
///
/// with K the stiffness [N/m] and M the masses [kg], positive definite or zero for some
/// unknowns, which then do not move; of both the lower triangle is read. None where K has
/// a negative eigenvalue: the body is unstable at rest.
///
/// Block Lanczos with full reorthogonalisation for the inverse of K + s M, M-inner
/// product; s is 1e-6 of the largest K_ii/M_ii, well below the first omega^2 of any mesh
/// that can be factored. Eigenvalues within 1e-9 of that largest one count as zero.
/// Blocks of twelve find values of up to that multiplicity, where a single vector finds
/// one of each but for rounding: a cube's come in pairs and triples, and six are zero.
/// From a fixed start: the same bits every time.
/// Source: Grimes, Lewis and Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228.
std::optional<NaturalModes> natural_modes(const Eigen::SparseMatrix<double>& stiffness,
                                          const Eigen::SparseMatrix<double>& masses,
                                          int count);

}  // namespace springcheck
