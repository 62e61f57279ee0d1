#pragma once

#include "comparisons/case_result.hpp"

namespace springcheck {

/// Measures and verdict of a solution that was found, wherever; no key, reference and
/// times.
CaseResult judged(const CaseSettings& settings, const Mesh& mesh, Solution found);

/// Runs one case, without its reference: solution, measures, verdict and times; no key.
/// A solver that breaks down (out of memory, say) leaves status not_converged and its
/// words as reason; only InputError is thrown.
CaseResult simulate(const CaseSettings& settings, const Mesh& mesh);

}  // namespace springcheck
