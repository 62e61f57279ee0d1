#pragma once

#include <Eigen/Core>
#include <array>

#include "meshing/cell_geometry.hpp"

namespace springcheck::mss {

/// Local node pairs of a hexahedron's springs (Golec 2018, figure 5.2).
using LocalSpring = std::array<std::size_t, 2>;
inline constexpr std::array<LocalSpring, 12> cell_edges{{{0, 1},
                                                         {1, 2},
                                                         {2, 3},
                                                         {3, 0},
                                                         {4, 5},
                                                         {5, 6},
                                                         {6, 7},
                                                         {7, 4},
                                                         {0, 4},
                                                         {1, 5},
                                                         {2, 6},
                                                         {3, 7}}};
inline constexpr std::array<LocalSpring, 12> cell_face_diagonals{{{0, 2},
                                                                  {1, 3},
                                                                  {4, 6},
                                                                  {5, 7},
                                                                  {0, 5},
                                                                  {1, 4},
                                                                  {1, 6},
                                                                  {2, 5},
                                                                  {2, 7},
                                                                  {3, 6},
                                                                  {3, 4},
                                                                  {0, 7}}};
inline constexpr std::array<LocalSpring, 4> cell_inner_diagonals{
    {{0, 6}, {1, 7}, {2, 4}, {3, 5}}};

/// Mean edge vectors X, Y, Z of a hexahedron, four edges each (Golec 2018, Eq. 5.18;
/// its corner order differs from ours, see CellNodes). As columns [m].
Eigen::Matrix3d mean_edges(const CornerPositions& x);

/// Volume approximated by V = X . (Y x Z) of the mean edges [m^3] (Golec 2018,
/// Eq. 5.19). It is what the volume correction acts on; exact for parallelepipeds.
double mean_edge_volume(const CornerPositions& x);

/// Gradient of mean_edge_volume, one column per corner [m^2]:
///
///     dV/dx_i = [sx_i Y x Z + sy_i Z x X + sz_i X x Y] / 4
///
/// with the signs s of the corner in the cell. Source: derivative of Eq. 5.19; the
/// printed Eq. 5.20 has the Y x Z sign of four corners wrong (5.21 then fails).
Eigen::Matrix<double, 3, 8> mean_edge_volume_gradient(const CornerPositions& x);

/// Second derivative of mean_edge_volume [m], 3x3 blocks in corner order.
Eigen::Matrix<double, 24, 24> mean_edge_volume_hessian(const CornerPositions& x);

}  // namespace springcheck::mss
