#pragma once

#include "comparisons/case_result.hpp"

namespace springcheck {

/// Runs one case, without its reference: solution, measures, verdict and times; no key.
/// A solver that breaks down (out of memory, say) leaves status not_converged and its
/// words as reason; only InputError is thrown.
CaseResult simulate(const CaseSettings& settings, const Mesh& mesh);

}  // namespace springcheck
