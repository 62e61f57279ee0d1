#include "statics/systems/unknowns.hpp"

namespace springcheck::statics {

Unknowns::Unknowns(const std::vector<bool>& is_free) : unknowns_(is_free.size(), -1) {
  for (std::size_t i = 0; i < is_free.size(); ++i) {
    if (is_free[i]) unknowns_[i] = count();
    (is_free[i] ? components_ : prescribed_).push_back(static_cast<Eigen::Index>(i));
  }
}

Eigen::VectorXd Unknowns::spread(const Eigen::VectorXd& free) const {
  Eigen::VectorXd all =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_.size()));
  all(components_) = free;
  return all;
}

}  // namespace springcheck::statics
