#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/history.hpp"
#include "comparisons/measures.hpp"

namespace springcheck {

/// How a case ended. The words are those of the command-line interface.
enum class Status {
  ok,
  wrinkled,
  inverted,
  indefinite,
  no_equilibrium,
  diverged,
  not_converged,
  refused
};

std::string_view name_of(Status status);
const std::vector<Status>& all_statuses();

/// Whether a reference is one simulation, or what it converges to on three grids.
enum class ReferenceGrid { one, converged };

/// A simulation that was asked for, with what its deviations are measured against.
struct Request {
  CaseSettings settings;
  // On the same mesh or a refinement of it; on the same mesh when `converged`:
  std::optional<CaseSettings> reference;
  ReferenceGrid reference_grid = ReferenceGrid::one;
};

/// The simulations its reference is made of: none, one, or three from coarse to fine.
std::vector<CaseSettings> reference_cases(const Request& request);

/// "fem-stvk:q1-sri"; with "@20,20,20" on cells other than the case's, "@converged" when
/// extrapolated. Empty without a reference.
std::string reference_label(const Request& request);

struct CaseResult {
  Request request;
  std::string key;  // identifies all that determines the result, see case_key
  Status status;
  std::vector<Status> flags;  // all of wrinkled, indefinite, inverted that apply
  std::string reason;         // in words, unless status is ok
  Measures measures;          // all empty when there is no equilibrium to measure
  Solution solution;
  // [m] displacement less the reference's, of each node; empty without a reference:
  std::vector<Vector3> deviation{};
  History history{};    // of dynamics, where samples were asked for
  double wall_s;        // solution and measures
  double solve_wall_s;  // solution alone
};

/// SHA-256 of settings, reference, mesh and program version.
std::string case_key(const Request& request, const Mesh& mesh);

/// Status and flags. Failed solutions keep the solver's word; else the first that applies
/// of inverted (a corner Jacobian below 0), wrinkled, indefinite, ok.
struct Verdict {
  Status status;
  std::vector<Status> flags;
};
Verdict judge(SolveStatus solved, bool inverted, bool wrinkled);

}  // namespace springcheck
