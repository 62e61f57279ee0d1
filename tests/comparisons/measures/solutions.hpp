#pragma once

#include <string>
#include <vector>

#include "meshing/loads/scene.hpp"
#include "tests/comparisons/settings.hpp"

namespace springcheck {

/// A block of .4 x .4 x .8 m in 4 x 4 x 8 cubes.
inline CaseSettings small_block(const std::string& scene,
                                const std::string& deformation = ".1") {
  std::vector<std::string> changes{"size=.4,.4,.8", "cells=4,4,8", "method=mss-cf"};
  if (scene != "bending") changes.push_back("deformation=" + deformation);
  return case_of(scene, changes);
}

/// A solution with the given displacement of each point, nothing else.
template <class Field>
Solution moved(const Mesh& mesh, Field&& field) {
  Solution solution{
      .status = SolveStatus::ok,
      .reason = {},
      .displacements = {},
      .reactions = std::vector<Vector3>(mesh.nodes().size(), Vector3::Zero()),
      .lever_arms = LeverArms::deformed,
      .strain_energy = 0,
      .load_fraction = 1,
      .steps = 1,
      .force_evaluations = 1};
  for (const Vector3& x : mesh.nodes()) solution.displacements.push_back(field(x));
  return solution;
}

}  // namespace springcheck
