#pragma once

#include <array>
#include <string>
#include <string_view>

#include "comparisons/cases/named.hpp"

namespace springcheck {

/// The deformation tests; mechanical_scene says what holds and loads the body.
enum class Test {
  compression,
  tension,
  shearing,
  torsion,
  bending,
  uniaxial,
  traction,
  affine
};

/// A test by its name in scene files.
struct TestName {
  Test value;
  std::string_view name;
  std::string_view answer{};  // measure of what the body answers to the load
  bool deforms = true;        // a plate is moved: there is a deformation
  bool turns = false;         // which is an angle
  bool slides = false;        // the body slides along both plates
  bool lower_plate = true;    // the body stands on one
  bool upper_plate = true;    // one on it is moved or loaded
};

template <>
inline constexpr std::array value_names<Test>{
    TestName{.value = Test::compression, .name = "compression", .answer = "plate_force"},
    TestName{.value = Test::tension, .name = "tension", .answer = "plate_force"},
    TestName{.value = Test::shearing, .name = "shearing", .answer = "plate_force_norm"},
    TestName{.value = Test::torsion,
             .name = "torsion",
             .answer = "plate_torque",
             .turns = true},
    TestName{.value = Test::bending,
             .name = "bending",
             .answer = "tip_deflection",
             .deforms = false,
             .upper_plate = false},
    TestName{.value = Test::uniaxial,
             .name = "uniaxial",
             .answer = "plate_force",
             .slides = true},
    TestName{.value = Test::traction,
             .name = "traction",
             .answer = "face_displacement",
             .deforms = false},
    TestName{.value = Test::affine,
             .name = "affine",
             .deforms = false,
             .lower_plate = false,
             .upper_plate = false}};

/// "45 deg" or "5 %".
std::string deformation_text(Test test, double deformation);

}  // namespace springcheck
