#include "mss/networks/cells.hpp"

namespace springcheck::mss {

void Cells::add(std::span<const NodeIndex> nodes, std::span<const Vector3> gradients,
                double volume, std::span<const CellSpring> springs) {
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  gradients_.insert(gradients_.end(), gradients.begin(), gradients.end());
  first_node_.push_back(nodes_.size());
  springs_.insert(springs_.end(), springs.begin(), springs.end());
  first_spring_.push_back(springs_.size());
  volumes_.push_back(volume);
}

}  // namespace springcheck::mss
