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

/// Orders of convergence that are believed. Below, three grids cannot tell a slow
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

/// Safety factors on the estimated error, after Roache, section 5.6: three grids that
/// show an order, and grids that do not.
inline constexpr double safety_with_order = 1.25, safety_without_order = 3;

/// What values converge to as the grid is refined.
struct Extrapolated {
  Eigen::MatrixXd value;          // q*
  std::optional<double> order{};  // observed
  Eigen::MatrixXd bar;            // half width about q*, entry by entry, not negative
};

/// Richardson extrapolation, one order for all entries, and the error bar of the grid
/// convergence index:
///
///     q* = q3 + (q3 - q2)/((h2/h3)^p - 1),   bar = 1.25 |q* - q3|
///     q* = q3,                               bar = 3 |q3 - q2|     without an order
///     q* = q3,                               bar = noise           when all has
///     converged
///
/// The changes whose ratio gives the order are the root mean squares over the entries of
/// q1 - q2 and q2 - q3, with the sign of their product: with one entry, the changes
/// themselves. Changes of at most `noise` (root mean square, in the unit of the values)
/// are what solvers leave, not the grid; no bar is smaller.
///
/// Source: as observed_order.
Extrapolated extrapolate(const GridSizes& sizes, const OnThreeGrids& values,
                         double noise);

}  // namespace springcheck
