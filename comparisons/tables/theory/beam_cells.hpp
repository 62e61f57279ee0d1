#pragma once

#include <map>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "comparisons/formats/table.hpp"
#include "comparisons/modes/beam_frequencies.hpp"
#include "comparisons/modes/beam_motion.hpp"

namespace springcheck {

/// Motion and theory of a cantilever's modes, for the table modes. Modes of a motion are
/// counted as they come.
class BeamCells {
 public:
  BeamCells(const CaseSettings& settings, const Mesh& mesh);

  /// Motion with its number, Euler-Bernoulli's frequency where it bends, and the theory's
  /// of the next mode, or multiplet, by one of its shapes.
  std::vector<Cell> next(const Eigen::VectorXd& shape);

 private:
  const Mesh& mesh_;
  SquareCantilever beam_;
  std::map<BeamMotion, int> count_;
};

}  // namespace springcheck
