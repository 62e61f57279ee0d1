#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

namespace springcheck {

/// Sizes h1 > h2 > h3 of the cells of three grids; their ratios may differ.
using GridSizes = std::array<double, 3>;

/// A quantity, or several at once (a field), on three grids from coarse to fine.
using OnThreeGrids = std::array<Eigen::MatrixXd, 3>;

/// Orders of convergence that are observed. Below, three grids cannot tell a slow
/// convergence from none; above, they cannot tell it from an accident of two errors that
/// cancel. Orders of finite elements lie well inside, on singular edges too.
inline constexpr double lowest_order = 0.3, highest_order = 4.5;

/// Order p of q(h) = q* + C h^p from the changes between three grids:
///
///     coarse_change/fine_change = (h1^p - h2^p)/(h2^p - h3^p)
///
/// coarse_change = q1 - q2, fine_change = q2 - q3. With a constant ratio r of sizes:
/// p = ln(coarse_change/fine_change)/ln r. None where q does not change monotonically or
/// p is outside [lowest_order, highest_order].
///
/// Source: P. J. Roache, "Verification and Validation in Computational Science and
/// Engineering", 1998, section 5.10; ASME V&V 20-2009, Eq. 2-4-4.
std::optional<double> observed_order(const GridSizes& sizes, double coarse_change,
                                     double fine_change);

/// Order p of error = C h^p, fitted to two or more grids: the slope of ln error over ln h
/// by least squares. None where an error is not positive.
std::optional<double> fitted_order(std::span<const double> sizes,
                                   std::span<const double> errors);

/// The order p by which a limit is told from three grids, and the safety factor F on what
/// is then left of the error on the finest:
///
///     p = formal order,                           F = 1.25   observed within 10 % of it
///     p = observed, at least .5, at most formal,  F = 3      observed otherwise
///     p = formal order,                           F = 3      they fall faster than any
///     p = .5,                                     F = 3      they fall slower, grow, or
///                                                            turn back
///
/// Source: W. L. Oberkampf, C. J. Roy, "Verification and Validation in Scientific
/// Computing", 2010, chapter 8, the implementation of the grid convergence index; of
/// changes that show no order our own.
struct BelievedOrder {
  std::optional<double> observed;
  double order, safety_factor;
  bool is_monotone;  // whether the changes fall, and in one direction
};
BelievedOrder believed_order(const GridSizes& sizes, double coarse_change,
                             double fine_change, double formal_order);

/// What is left of the error on a grid, by an order p, over the change from one coarser
/// by that ratio: 1/(ratio^p - 1).
double rest_by_order(double ratio, double order);

/// Safety factors where orders are observed near the formal one, and elsewhere; two
/// grids, which show no order, have the formal one and the latter. Source: as
/// believed_order.
inline constexpr double asymptotic_safety = 1.25, cautious_safety = 3;

/// What values converge to as the grid is refined.
struct Extrapolated {
  Eigen::MatrixXd value;          // q*
  std::optional<double> order{};  // observed
  Eigen::MatrixXd error_bound;    // half width about q*, entry by entry, not negative
  // F/((h2/h3)^p - 1); none where all has converged:
  std::optional<double> index{};
};

/// Richardson's extrapolation by the order p that is believed, one for all entries, and
/// the grid convergence index F e, e = |q3 - q2|/((h2/h3)^p - 1), which its source
/// centres at the finest grid's value. The error bound holds that whole interval:
///
///     q* = q3 + (q3 - q2)/((h2/h3)^p - 1),   bound = (F + 1) e
///     q* = q3,                               bound = F e   (they grow or turn back)
///     q* = q3,                               bound = noise   (all has converged)
///
/// The changes whose ratio gives the order are the root mean squares over the entries of
/// q1 - q2 and q2 - q3, with the sign of their product: with one entry, the changes
/// themselves. Changes of at most `noise` (root mean square, in the unit of the values)
/// are what solvers leave, not the grid; no error bound is smaller.
///
/// Source: as believed_order.
Extrapolated extrapolate(const GridSizes& sizes, const OnThreeGrids& values, double noise,
                         double formal_order);

}  // namespace springcheck
