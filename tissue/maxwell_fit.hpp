#pragma once

#include "tissue/maxwell_branches.hpp"

namespace springcheck::tissue {

struct Range {
  double from, to;  // 0 < from <= to

  [[nodiscard]] bool contains(double value) const { return value >= from && value <= to; }
};

/// The range in which a model is to follow the law. Outside, it is a guess: a caller says
/// so.
struct FitRange {
  Range strains{0.01, 1};
  Range rates{0.0151, 0.67};            // [1/s], of the thesis's figures
  Range times_held{1e-3, 100};          // [s] after a ramp of these strains and rates
  Range angular_frequencies{0.1, 100};  // [rad/s]
  // [1/s] To this rate the guess is to stay within a fifth of the law: where a body is
  // squeezed out it is strained several times faster than its plates tell.
  double fastest_guess = 50;
};

inline constexpr double largest_error_of_guess = 0.2;

/// Largest relative deviations from the law over the range, and the root mean square of
/// ln(model/law) over all strains and rates; `guess` is of constant rates beyond the
/// range's, up to the fastest guess.
struct FitErrors {
  double constant_rate_rms, constant_rate, ramp_and_hold, storage, loss, guess;
};

struct MaxwellFit {
  MaxwellModel model;
  FitRange range;
  FitErrors errors;
};

// The default is the smallest number that holds tissue's bands: 2 percent, 5 in G''.
inline constexpr int default_branches = 6, most_branches = 32;

/// The model of 2 to most_branches branches that follows the law best in the range: least
/// squares of the relative deviations of stresses at constant rate and after ramps, of G'
/// and, counted .4, of G'' (tissue's bands are 2 and 5 percent), on samples spaced evenly
/// in ln. The stresses are linear in all G_i, B_i and eta: non-negative least squares
/// finds those. The relaxation times are spaced evenly in ln between a first and a last
/// one, the best of a fixed grid that the range sets. Deterministic; tenths of a second.
///
/// The range alone does not tell what a branch does that is faster than all in it: the
/// stresses at constant rate beyond it count too, .05 of the others and twice that until
/// errors.guess is at most largest_error_of_guess, at most .8.
/// At any rate the stress rises with the rate, as no modulus is negative.
///
/// More branches hold over a wider range: about one per decade of time.
/// Throws InputError for a law, range or number of branches that cannot be.
MaxwellFit fit_maxwell_model(const BipowerLaw& law, const FitRange& range = {},
                             int branches = default_branches);

/// Deviations of a model from the law over the range, on samples four times as dense as
/// the fit's.
FitErrors errors_of(const MaxwellModel& model, const BipowerLaw& law,
                    const FitRange& range);

}  // namespace springcheck::tissue
