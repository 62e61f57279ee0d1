#pragma once

#include <filesystem>
#include <optional>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// Measures and verdict of a solution that was found, wherever; no key, reference and
/// times.
CaseResult judged(const CaseSettings& settings, const Mesh& mesh, Solution found);

/// How a case in dynamics is watched over.
struct Watch {
  std::optional<std::filesystem::path>
      checkpoint{};  // written now and then, gone on from
  double seconds_between_checkpoints = 60;
  bool shows_progress = false;           // on stderr, where that is a terminal
  Revisions revisions = Revisions::own;  // of a checkpoint that it goes on from
};

/// Runs one case, without its reference: solution, measures, verdict and times; no key.
/// threads: of dynamics; other solvers' inner loops take those that TBB has to spare.
/// A solver that breaks down leaves status not_converged and its words as reason. Throws
/// InputError, and what says nothing about the case: std::bad_alloc above all.
CaseResult simulate(const CaseSettings& settings, const Mesh& mesh, int threads = 1,
                    const Watch& watch = {});

}  // namespace springcheck
