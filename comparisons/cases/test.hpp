#pragma once

#include <array>
#include <string>
#include <string_view>

#include "comparisons/names/named.hpp"

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
  std::string_view description;
  std::string_view answer{};   // measure of what the body answers to the load
  std::string_view passive{};  // "pressed by", before a load; of tests that pages tell of
  bool deforms = true;         // a plate is moved: there is a deformation
  bool turns = false;          // which is an angle
  bool slides = false;         // the body slides along both plates
  bool lower_plate = true;     // the body stands on one
  bool upper_plate = true;     // one on it is moved or loaded
};

template <>
inline constexpr std::array value_names<Test>{
    TestName{.value = Test::compression,
             .name = "compression",
             .description = "the upper plate comes down by a part of the height",
             .answer = "plate_force",
             .passive = "pressed by"},
    TestName{.value = Test::tension,
             .name = "tension",
             .description = "the upper plate is lifted by a part of the height",
             .answer = "plate_force",
             .passive = "pulled by"},
    TestName{.value = Test::shearing,
             .name = "shearing",
             .description = "the upper plate moves sideways by a part of the height",
             .answer = "plate_force_norm",
             .passive = "sheared by"},
    TestName{.value = Test::torsion,
             .name = "torsion",
             .description = "the upper plate turns about the vertical through its centre",
             .answer = "plate_torque",
             .passive = "turned by",
             .turns = true},
    TestName{.value = Test::bending,
             .name = "bending",
             .description = "a beam that is held at one end bends under its weight",
             .answer = "tip_deflection",
             .passive = "bent by its weight,",
             .deforms = false,
             .upper_plate = false},
    TestName{.value = Test::uniaxial,
             .name = "uniaxial",
             .description = "as compression or tension, by plates along which the body "
                            "slides",
             .answer = "plate_force",
             .slides = true},
    TestName{.value = Test::traction,
             .name = "traction",
             .description = "a force per area, and no plate, loads the upper face",
             .answer = "face_displacement",
             .deforms = false},
    TestName{.value = Test::affine,
             .name = "affine",
             .description = "the whole boundary moves by one displacement gradient H",
             .deforms = false,
             .lower_plate = false,
             .upper_plate = false}};

/// "45 deg" or "5 %".
std::string deformation_text(Test test, double deformation);

}  // namespace springcheck
