#include "statics/systems/linear_solver.hpp"

namespace springcheck::statics {
namespace {

// Seconds of whole solutions on two cores, cubes compressed by 5 % at nu = .25 | .499:
//
//     unknowns                 direct        conjugate gradients   multigrid
//     mss-cf, 10^3    2,700    .08   .16     .02   .16             .3    .5
//     20^3           22,800    1.7   2.8     .2    1.4             .9    3.4
//     30^3           81,000    14    22      1.5   13              2.4   15
//     fem-hencky 10^3          .13   .28     .07   .31             .4    .9
//     20^3                     2.1   5.0     .6    3.4             1.2   7.4
//     30^3                     -     -       2.4   28              3.6   31
//     q2, 8^3        13,500    .9    2.2     .4    3.8             1.2   12
//     12^3           44,000    5.6   14      2.1   26              3.6   -
//
// A factor tells definiteness for certain, and costs a second at most up to the first
// limit; beyond the second multigrid's iterations, which do not grow, outweigh theirs.
constexpr std::ptrdiff_t most_solved_directly = 10'000;
constexpr std::ptrdiff_t most_solved_by_conjugate_gradients = 250'000;

}  // namespace

LinearSolver linear_solver_taken(LinearSolver wanted, std::ptrdiff_t unknowns) {
  using enum LinearSolver;
  if (wanted != automatic) return wanted;
  if (unknowns <= most_solved_directly) return direct;
  return unknowns <= most_solved_by_conjugate_gradients ? conjugate_gradients : multigrid;
}

}  // namespace springcheck::statics
