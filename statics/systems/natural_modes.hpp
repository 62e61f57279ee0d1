#pragma once

#include <Eigen/SparseCore>
#include <optional>

namespace springcheck {

/// Small free vibrations of a body at rest.
struct NaturalModes {
  // Shapes that no force resists: six of a free body, fewer where it is held, more where
  // springs leave other motions free.
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
/// Lanczos for the inverse of K + s M with implicit restarts, of Spectra (small problems:
/// Eigen's for full matrices); s is 1e-6 of the largest K_ii/M_ii, well below the first
/// omega^2 of any mesh that can be factored. Eigenvalues within 1e-9 of that largest one
/// count as zero. A cube's values come in pairs and triples, and six are zero: of a value
/// that comes several times Lanczos finds the copies by rounding, which the tests try up
/// to fourteen copies, and nothing proves. The same bits every time. Throws
/// std::runtime_error where Lanczos does not converge in 1000 restarts.
/// Source: Grimes, Lewis and Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228 (the shifted
/// inverse); Calvetti, Reichel and Sorensen, ETNA 2 (1994) 1 (the restarts).
std::optional<NaturalModes> natural_modes(const Eigen::SparseMatrix<double>& stiffness,
                                          const Eigen::SparseMatrix<double>& masses,
                                          int count);

}  // namespace springcheck
