#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/measures/hourglassing.hpp"
#include "comparisons/measures/wrinkles.hpp"

namespace springcheck {

/// An equilibrium with its label, and what the detectors see of it.
struct State {
  std::string scene, method;
  std::string name;
  bool is_wrinkled;  // its label
  Wrinkling surface;
  Hourglassing inside;

  /// The factor by which the thresholds of one detector would have to grow, or those of
  /// both to shrink, for another verdict: above 1 the state is called wrinkled.
  [[nodiscard]] double score() const {
    return std::max(
        std::min(surface.alternation.value_or(-1) / *wrinkled_above.alternation,
                 surface.amplitude / wrinkled_above.amplitude),
        std::min(inside.alternation.value_or(0) / *hourglassing_above.alternation,
                 inside.amplitude / hourglassing_above.amplitude));
  }
};

/// A lattice on cubes, and the load up to which its path is followed.
struct Path {
  const char* scene;
  std::vector<std::string> changes;
  double far;
};

/// Adds the states of a path with their labels. Before its limit a path is smooth. Beyond
/// a limit with a critical mode, by a twentieth, a quarter and a half, a state is solved
/// again from noise; it is wrinkled where the mode is shorter than three cells, however
/// little of it the state shows, and smooth where the mode is of four cells and more:
/// buckling is not wrinkling. Between the two there is no label, nor where a cell is
/// inverted or no equilibrium found, which the state's status tells.
void add_states(std::vector<State>& states, const Path& path);

/// Equilibria far from any limit of their own, of laws and cells that do not wrinkle
/// before they invert.
struct Smooth {
  const char* scene;
  std::vector<std::string> changes;
  std::vector<double> loads;
};

void add_states(std::vector<State>& states, const Smooth& smooth);

/// No method wrinkles on tetrahedra before it inverts. An equilibrium there is given the
/// critical mode of a lattice on cubes with the same nodes, higher and higher.
struct Moded {
  Path lattice;
  std::vector<std::string> changes;  // of the equilibrium, at the lattice's limit
};

/// Height of the mode, its largest displacement over the edge, from which on the
/// detectors call it: of .01, .02, .04, ... .64, and none of them. Without it the state
/// is smooth.
std::optional<double> height_called(std::vector<State>& states, const Moded& moded);

}  // namespace springcheck
