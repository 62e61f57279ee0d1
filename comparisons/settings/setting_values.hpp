#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

// One setting each, read from what the user gave. All throw InputError.

Test test_of(const Given& given);
std::vector<Method> methods_of(const Given& given);  // each once
ElementName element_of(const Given& given);
LatticeName lattice_of(const Given& given);
std::vector<Status> expect_of(const Given& given);

/// The method or element of this name, which stands in what was given.
Method method_named(const Given& given, const std::string& name);
ElementName element_named(const Given& given, const std::string& name);

PlateContact plates_of(const Given& given);
mss::StiffnessForm stiffness_form_of(const Given& given);
mss::VolumeCorrection correction_of(const Given& given);
std::optional<Solver> solver_named(const Given& given);
mss::Precision precision_of(const Given& given);
int sample_count_of(const Given& given);
fem_reference::LinearSolver linear_solver_of(const Given& given);
fem_reference::LatticeDirection lattice_direction_of(const Given& given);

BodyShape shape_of(const Given& given);  // of those that are no file
MeshUnit mesh_unit_of(const Given& given);
CellPattern pattern_of(const Given& given);
std::array<double, 3> size_of(const Given& given);
std::array<int, 3> cells_of(const Given& given);
double poisson_ratio_of(const Given& given);
mss::LatticeStiffness stiffness_of(const Given& given);  // none negative, not all 0
double not_negative_of(const Given& given);
std::optional<double> time_step_of(const Given& given);  // none: auto
unsigned seed_of(const Given& given);

/// The law of an organ, or of four parameters.
tissue::BipowerLaw organ_of(const Given& given);
tissue::BipowerLaw law_of(const Given& given);
int branch_count_of(const Given& given);
int time_steps_of(const Given& given);

/// Times above 0, ascending, without their fractions; those, one for each, not all 0.
dynamics::LoadPath load_times_of(const Given& given);
void set_fractions(dynamics::LoadPath& path, const Given& given);
double cycles_of(const Given& given);

/// Whether the body is, somewhere on the way from 0 to the gradient H of u = H X.
bool turns_inside_out(const Eigen::Matrix3d& gradient);

/// A strain or, in torsion, an angle: positive but in uniaxial, whose sign is free.
double deformation_of(const Given& given, Test test);

/// An acceleration [m/s^2] other than zero.
Vector3 gravity_of(const Given& given);

/// A traction [Pa] other than zero, along z where the body slides on its plate.
Vector3 traction_of(const Given& given, PlateContact plates);

/// A displacement gradient H other than zero that turns nothing inside out on the way:
/// I + s H is regular for s in [0, 1].
Eigen::Matrix3d gradient_of(const Given& given);

}  // namespace springcheck
