#pragma once

#include <Eigen/Core>
#include <string_view>

#include "meshing/mesh.hpp"

namespace springcheck {

/// What a beam along z does in a mode.
enum class BeamMotion { bending, torsion, stretching, other };

std::string_view name_of(BeamMotion motion);

/// The motion that holds more than half of sum |u|^2 over the nodes, of its sections'
/// (the nodes of one z) rigid motions: shift sideways, turn about the axis, shift along
/// it. displacements: entries 3 node + component.
BeamMotion beam_motion(const Mesh& mesh, const Eigen::VectorXd& displacements);

}  // namespace springcheck
