#include "comparisons/modes/beam_motion.hpp"

#include <map>
#include <vector>

namespace springcheck {

std::string_view name_of(BeamMotion motion) {
  switch (motion) {
    case BeamMotion::bending:
      return "bending";
    case BeamMotion::torsion:
      return "torsion";
    case BeamMotion::stretching:
      return "stretching";
    case BeamMotion::other:
      return "other";
  }
  return {};
}

BeamMotion beam_motion(const Mesh& mesh, const Eigen::VectorXd& displacements) {
  std::map<double, std::vector<NodeIndex>> sections;
  for (NodeIndex node = 0; node < mesh.nodes().size(); ++node)
    sections[mesh.nodes()[node].z()].push_back(node);
  double sideways = 0, turning = 0, along = 0;  // parts of sum |u|^2
  for (const auto& [z, nodes] : sections) {
    const auto count = static_cast<double>(nodes.size());
    Vector3 centre = Vector3::Zero(), shift = Vector3::Zero();
    for (const NodeIndex node : nodes) {
      centre += mesh.nodes()[node] / count;
      shift += displacements.segment<3>(3 * node) / count;
    }
    double turn = 0, arms = 0;  // angle times arms, sum r^2
    for (const NodeIndex node : nodes) {
      const Vector3 r = mesh.nodes()[node] - centre;
      turn += r.cross(Vector3(displacements.segment<3>(3 * node))).z();
      arms += r.head<2>().squaredNorm();
    }
    sideways += count * shift.head<2>().squaredNorm();
    along += count * shift.z() * shift.z();
    if (arms > 0) turning += turn * turn / arms;
  }
  const double half = displacements.squaredNorm() / 2;
  if (sideways > half) return BeamMotion::bending;
  if (turning > half) return BeamMotion::torsion;
  if (along > half) return BeamMotion::stretching;
  return BeamMotion::other;
}

}  // namespace springcheck
