#include "mss/networks/masses.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <span>

namespace springcheck::mss {
std::vector<double> nodal_volumes(const CornerPositions& x) {
  const auto n = static_cast<double>(x.cols());
  const Vector3 mean = x.rowwise().mean();
  const CornerPositions from_mean = x.colwise() - mean;
  const Eigen::Matrix3d S = from_mean * from_mean.transpose() / n;
  const Eigen::VectorXd shares =
      1 + (from_mean.transpose() * S.inverse() * (cell_centroid(x) - mean)).array();
  const double equal = equal_nodal_volume(x);
  std::vector<double> volumes(static_cast<std::size_t>(x.cols()), equal);
  if ((shares.array() > 0).all())
    std::ranges::transform(shares, volumes.begin(),
                           [&](double share) { return equal * share; });
  return volumes;
}

double equal_nodal_volume(const CornerPositions& x) {
  return cell_volume(x) / static_cast<double>(x.cols());
}

}  // namespace springcheck::mss
