#pragma once

#include <optional>
#include <span>

#include "meshing/loads/scene.hpp"

namespace springcheck {

/// How much the free surface zigzags, on its worst side.
struct Wrinkling {
  // 1 for a zigzag from node to node, near -1 for a smooth curve; none where the
  // amplitude is round-off, below 1e-7:
  std::optional<double> alternation;
  double amplitude;  // height of the zigzag over edge length and surface strain
};

/// Measures the wrinkling of the free surface, on any cells. The boundary faces are
/// sorted into six sides, each by the axis nearest to its outward normal. A node is
/// looked at where all faces around it are of one side and no plate holds it. From its
/// displacement is taken what the best affine fit to those of its n neighbours along the
/// faces' edges (least squares, in the plane of the side) gives at its place:
///
///     r = u - (u_fit at the node)
///
/// Translations, and on plane sides rotations and homogeneous strain, have no r; on a
/// regular grid it is u less the mean of the four neighbours. A side has
///
///     alternation  largest -v.C v / v.S v over the directions v in its plane, with
///                      C = sum r_a.r_b t t^T
///                      S = sum (|r_a|^2 + |r_b|^2)/2 t t^T
///                  over the edges, t an edge's unit vector, r = 0 where a node is not
///                  looked at
///     amplitude    rms r / (h e), h the root mean square edge, e that of |E| over the
///                  nodes looked at on all sides, E Green's strain in the plane by the
///                  same fit
///
/// On irregular meshes the amplitude depends on conventions: here all neighbours count
/// alike in the fit, and h is of the edges looked at. Others, such as weights by
/// distance, were found to differ by 3 to 12 %.
///
/// On a grid C and S are diagonal, and the alternation is that of the worse grid line
/// direction: for n nodes in a line it is at most cos(pi/(n + 1)), 1/2 for two, .71 for
/// three; for a zigzag it is (n - 1)/n. A zigzag in one direction has r = its amplitude
/// a, one in two directions r = 2 a.
///
/// There is none without a node to look at: where the whole boundary is imposed, or on
/// blocks of one cell. On curved surfaces rotations leave a smooth r.
std::optional<Wrinkling> measure_wrinkling(const Mesh& mesh, const Scene& scene,
                                           std::span<const Vector3> displacements);

/// The limits above both of which a surface is wrinkled: by zigzags shorter than three
/// cells, cos(2 pi/3) = -1/2. Waves of three to four cells are not told from the bulges
/// of few cells. What they miss of states whose label is known is counted by
/// tests/comparisons/running/labelled_states_test.cpp, thresholds of other scenes and
/// other methods beside them.
///
/// Two nodes in a line, a side of three cells, cannot alternate by more: such sides are
/// never called wrinkled.
inline constexpr Wrinkling wrinkled_above{.alternation = 0.5, .amplitude = 0.12};
bool is_wrinkled(const Wrinkling& wrinkling);

}  // namespace springcheck
