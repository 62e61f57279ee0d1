#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparisons/methods.hpp"
#include "meshing/gmsh.hpp"
#include "mss/solve.hpp"

namespace springcheck {

/// The five deformation tests. The body is a block with its axis along z, its lower end
/// face glued to a fixed plate.
enum class Test { compression, tension, shearing, torsion, bending };

std::string_view name_of(Test test);
std::string_view name_of(mss::Solver solver);
std::string_view name_of(mss::StiffnessForm form);

/// Everything that determines one simulation.
struct CaseSettings {
  std::string scene;
  Test test;
  BlockSize block;
  Material material;
  Vector3 gravity;                    // [m/s^2]; zero but in bending
  std::optional<double> deformation;  // strain, [rad] in torsion; none in bending
  Method method;
  // Finite elements:
  ElementName element;
  // Springs:
  mss::StiffnessForm stiffness_form;
  double diagonal_ratio;
  mss::Solver solver;
  mss::DynamicsSettings dynamics;  // of the semi-implicit solver
  unsigned seed;                   // of the static solver
};

/// The case as both solvers receive it: plates and their motion, material, gravity.
///   compression, tension: the upper plate moves along -z, +z by deformation * height
///   shearing:             along +x by deformation * height
///   torsion:              turns about +z through its centre
///   bending:              no upper plate, gravity acts
Scene mechanical_scene(const CaseSettings& settings);

/// The scene's name and the settings its method reads, and no others, as JSON: a setting
/// that cannot change the result does not change it.
nlohmann::json settings_json(const CaseSettings& settings);

/// "fem-stvk:q1-sri" for finite elements, "mss-cf" for springs.
std::string label(const CaseSettings& settings);

}  // namespace springcheck
