#pragma once

#include <optional>
#include <span>

#include "comparisons/case.hpp"

namespace springcheck {

/// How much a free face's grid lines zigzag, on the worst face and direction.
struct Wrinkling {
  double alternation;  // -sum d2_k d2_(k+1) / sum d2^2: -1 for a smooth curve, 1 for a
                       // zigzag of one cell's period
  double amplitude;    // rms(d2) / (4 h strain): height of the zigzag over h strain
  double differences;  // second differences in a grid line
  double strain;       // as given
};

/// d2 are the second differences of the displacement normal to the face along its grid
/// lines. Every region is a free face but those on plates, glued or sliding: both hold
/// the normal displacement. None where a boundary gradient holds all faces; what zigzags
/// inside then shows in affine_deviation_relative. `strain` is the largest strain the
/// test imposes, see imposed_strain.
/// Valid for regions of quadrilaterals whose inner nodes have four neighbours.
std::optional<Wrinkling> measure_wrinkling(const Mesh& mesh, const Scene& scene,
                                           double strain,
                                           std::span<const Vector3> displacements);

/// Alternation above 1/2 and amplitude above .02: between the smooth (<= -.08) and the
/// wrinkled (>= .79) states of an independent prototype.
///
/// Lines of four cells have three second differences, in which a bulge with higher ends
/// alternates as a zigzag does (.5 to .69 and .67 to .71 measured; the same bulge on five
/// cells .15 to .25). Only the height tells them apart: over h strain a bulge's grows
/// with the strain, a zigzag's does not, so it must be above .28 strain too. Measured:
/// finite elements pressed by 20 to 60 % reach .27 strain; mss-nfd pulled by up to 20 %
/// begins at .30 strain, pressed at 2.6 strain. A weak zigzag goes unseen there at larger
/// strains (mss-nfd pulled by 30 %: .22 strain). Shorter lines cannot alternate above
/// 1/2, but for rounding: they are never called wrinkled.
bool is_wrinkled(const Wrinkling& wrinkling);

/// Largest strain a test imposes on its faces [-]: the deformation itself; in torsion
/// angle * half width / height; in bending that of Euler-Bernoulli's outer fibre at the
/// clamp, (h/2) w L^2 / (2 E I); in traction t the same of a beam with that end load,
/// (|t_z| + 6 L (|t_x|/size_x + |t_y|/size_y)) / E; in affine the gradient's norm. E is
/// the material's, of mss-custom its lattice's mss::axial_modulus; where that is 0, the
/// strain of a load is infinite.
double imposed_strain(const CaseSettings& settings);

}  // namespace springcheck
