#pragma once

#include <string_view>

#include "comparisons/names/named.hpp"
#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// How a simulation fails as a model of its body. A case may fail in several ways; the
/// order is that of failure_of.
enum class Failure {
  none,
  not_covered,   // the method refuses the scene, which is no failure of the body's
  solver,        // the solver gave up: nothing is known of the body
  blow_up,       // the energy of a motion grew without end
  inversion,     // a cell is turned inside out at a corner
  limit_point,   // no equilibrium beyond some part of the load
  wrinkling,     // a free face zigzags from cell to cell
  hourglassing,  // the inside alternates in modes that the cells' mean strain does not
                 // see
  loss_of_definiteness,  // equilibrium, but no minimum of the energy
  locking                // plate force far above a control's that does not lock
};

inline bool fails(Failure failure) {
  return failure != Failure::none;
}

struct FailureName {
  Failure value;
  std::string_view name;
  char letter;  // in maps
  std::string_view description;
};

template <>
inline constexpr std::array value_names<Failure>{
    FailureName{Failure::none, "none", '.',
                "equilibrium, tangent positive definite, nothing of what follows"},
    FailureName{Failure::not_covered, "not covered", '-', "the method refuses the scene"},
    FailureName{Failure::solver, "solver failure", '?',
                "the solver gave up on a path that was stable as far as it came: says "
                "nothing of the body"},
    FailureName{Failure::blow_up, "blow-up", 'B', "a motion left all bounds"},
    FailureName{Failure::inversion, "inversion", 'I',
                "a cell is turned inside out at a corner"},
    FailureName{Failure::limit_point, "limit point", 'P',
                "no equilibrium beyond some part of the load"},
    FailureName{Failure::wrinkling, "wrinkling", 'W',
                "a free face zigzags from cell to cell; of a path's limit, the mode that "
                "becomes unstable is shorter than four edges between nodes"},
    FailureName{Failure::hourglassing, "hourglassing", 'H',
                "the inside of hexahedra alternates from cell to cell in modes that the "
                "cells' mean strain does not see: more than half of their hourglass "
                "displacement, higher than .05 of edge times strain"},
    FailureName{Failure::loss_of_definiteness, "loss of definiteness", 'D',
                "equilibrium, but no minimum of the energy, or one beyond where the path "
                "from rest lost its stability"},
    FailureName{
        Failure::locking, "locking", 'L',
        "with --locking: plate force or torque more than 10 % above that of the same law "
        "on q1-sri (fem-cauchy-born, for lattices); on hexahedra alone"}};

// The definitions of failures, each of a case alone but for locking.

bool refuses(const CaseResult& result);
/// Whether the solver did not converge short of the load, on a path that was stable as
/// far as it was followed. This is distinct from all failures of the body.
bool solver_fails(const CaseResult& result);
/// Whether positions leave all bounds, see dynamics::march.
bool blows_up(const CaseResult& result);
/// Whether the smallest corner Jacobian of a cell is below 0; for solver limit, on the
/// way.
bool inverts(const CaseResult& result);
/// Whether the path turns back, the energy falls without end, or what is left is another
/// branch.
bool ends_in_limit_point(const CaseResult& result);
/// Whether it wrinkles, see is_wrinkled; for solver limit, whether the mode that becomes
/// unstable is shorter than four cells.
bool wrinkles(const CaseResult& result);
/// Whether it hourglasses, see is_hourglassing.
bool hourglasses(const CaseResult& result);
/// Whether the tangent is not positive definite, now or, with a path that is followed
/// beyond, on the way.
bool loses_definiteness(const CaseResult& result);
/// Whether |force| on the moved plate, in torsion |torque|, is more than a tenth above
/// the control's, which must be an equilibrium of the same law on the same mesh without
/// locking (q1-sri).
bool locks(const CaseResult& result, const CaseResult& control);

/// The first of the failures, in the order of Failure, that the case has.
Failure failure_of(const CaseResult& result);

}  // namespace springcheck
