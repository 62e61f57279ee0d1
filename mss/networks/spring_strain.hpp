#pragma once

#include <vector>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// The engineering strain of largest magnitude among each cell's springs, with its sign
/// [-]:
///
///     e = l/L - 1      springs of constant rest length L
///     e = |F n| - 1    virtual springs, along their axes n in the cell's F
///
/// Springs of affine rest length do not count: they are at rest in every affine state.
/// displacements [m], one per node.
std::vector<double> largest_spring_strains(const Network& network,
                                           const std::vector<Vector3>& displacements);

}  // namespace springcheck::mss
