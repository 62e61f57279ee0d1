#include "mss/networks/method_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "mss/networks/box_lattice.hpp"
#include "mss/networks/cell_springs.hpp"
#include "mss/networks/hourglass.hpp"
#include "mss/networks/uniform_stiffness.hpp"

namespace springcheck::mss {
namespace {

const LatticeConstants& constants_of(const NetworkSettings& settings) {
  if (!settings.constants)
    throw std::invalid_argument("mss: method custom needs NetworkSettings::constants");
  return *settings.constants;
}

/// mu of the springs.
double spring_modulus(const Material& material, StiffnessForm form) {
  return form == StiffnessForm::shear_modulus ? lame_constants(material).mu
                                              : 0.4 * material.young_modulus;
}

/// One spring for each of the pairs, of stiffness(pair, r) where that is not 0.
template <class Stiffness>
void add_springs(std::vector<CellSpring>& springs, const CornerPositions& x,
                 std::span<const LocalEdge> pairs, const Stiffness& stiffness) {
  for (const LocalEdge& ends : pairs) {
    const Vector3 r = along(x, ends);
    if (const double k = stiffness(ends, r); k != 0)
      springs.push_back({.ends = ends, .stiffness = k, .rest = r});
  }
}

std::vector<CellSpring> cube_springs(const CornerPositions& x,
                                     const LatticeStiffness& k) {
  std::vector<CellSpring> springs;
  const auto add = [&](std::span<const LocalEdge> pairs, double share) {
    add_springs(springs, x, pairs,
                [&](const LocalEdge&, const Vector3&) { return share; });
  };
  add(edges(CellType::hexahedron), k.edge / 4);
  add(face_diagonals(CellType::hexahedron), k.face_diagonal / 2);
  add(inner_diagonals(CellType::hexahedron), k.inner_diagonal);
  return springs;
}

std::vector<CellSpring> box_springs(const CornerPositions& x, const BoxLattice& q) {
  std::vector<CellSpring> springs;
  add_springs(springs, x, edges(CellType::hexahedron),
              [&](const LocalEdge& edge, const Vector3& r) {
                return q.edge[edge_direction(edge)] * r.squaredNorm();
              });
  add_springs(springs, x, face_diagonals(CellType::hexahedron),
              [&](const LocalEdge& diagonal, const Vector3& r) {
                return q.face_diagonal[face_direction(diagonal)] * r.squaredNorm();
              });
  add_springs(springs, x, inner_diagonals(CellType::hexahedron),
              [&](const LocalEdge&, const Vector3& r) {
                return q.inner_diagonal * r.squaredNorm();
              });
  return springs;
}

/// The formula in the modulus that the settings name.
LatticeStiffness isotropic_lattice(const Material& material, double cell_edge,
                                   StiffnessForm form, double diagonal_ratio) {
  return form == StiffnessForm::shear_modulus
             ? shear_modulus_form(lame_constants(material).mu, cell_edge, diagonal_ratio)
             : young_modulus_form(material.young_modulus, cell_edge, diagonal_ratio);
}

LatticeStiffness with_face_diagonals(const Material& material, double cell_edge,
                                     const NetworkSettings& settings) {
  return isotropic_lattice(material, cell_edge, settings.stiffness_form,
                           settings.diagonal_ratio);
}

LatticeStiffness without_face_diagonals(const Material& material, double cell_edge,
                                        const NetworkSettings& settings) {
  return isotropic_lattice(material, cell_edge, settings.stiffness_form, 0);
}

LatticeStiffness after_baudet(const Material& material, double cell_edge,
                              const NetworkSettings& /*settings*/) {
  return baudet_stiffness(material.young_modulus, material.poisson_ratio, cell_edge);
}

LatticeStiffness of_one_stiffness(const Material& material, double cell_edge,
                                  const NetworkSettings& /*settings*/) {
  return uniform_stiffness(material.young_modulus, cell_edge);
}

LatticeStiffness given(const Material& /*material*/, double /*cell_edge*/,
                       const NetworkSettings& settings) {
  return constants_of(settings).stiffness;
}

template <auto stiffness>
std::vector<CellSpring> on_cubes(const CornerPositions& x, double volume,
                                 const Material& material,
                                 const NetworkSettings& settings) {
  return cube_springs(x, stiffness(material, std::cbrt(volume), settings));
}

std::vector<CellSpring> on_boxes(const CornerPositions& x, double volume,
                                 const Material& material,
                                 const NetworkSettings& settings) {
  const std::array<double, 3> box = box_edges(x).value();
  if (is_cube(box)) return on_cubes<with_face_diagonals>(x, volume, material, settings);
  const double mu = spring_modulus(material, settings.stiffness_form);
  return box_springs(x, box_lattice(mu, box).value());
}

template <auto stiffness>
std::vector<CellSpring> on_tetrahedra(const CornerPositions& x, double volume,
                                      const Material& material,
                                      const NetworkSettings& /*settings*/) {
  std::vector<CellSpring> springs;
  add_springs(springs, x, edges(CellType::tetrahedron),
              [&](const LocalEdge&, const Vector3& r) {
                return stiffness(material.young_modulus, volume, r.norm());
              });
  return springs;
}

double after_lloyd(double young_modulus, double /*volume*/, double length) {
  return lloyd_stiffness(young_modulus, length);
}

std::vector<CellSpring> against_hourglasses(const CornerPositions& x, double volume,
                                            const Material& material,
                                            const NetworkSettings& /*settings*/) {
  return hourglass_springs(x, volume, material);
}

double uncorrected(const Material& /*material*/, const NetworkSettings& /*settings*/) {
  return 0;
}

double corrected(const Material& material, const NetworkSettings& /*settings*/) {
  return volume_correction_modulus(material);
}

double corrected_if_on(const Material& material, const NetworkSettings& settings) {
  return settings.volume_correction == VolumeCorrection::on
             ? volume_correction_modulus(material)
             : 0;
}

double corrected_as_given(const Material& /*material*/, const NetworkSettings& settings) {
  return constants_of(settings).volume_modulus;
}

std::optional<std::string> with_negative_edges(const Material& material) {
  if (material.poisson_ratio > -0.25) return std::nullopt;
  return fmt::format(
      "mss-baudet covers nu in (-0.25, 0.5): its edge stiffness is not positive at "
      "nu = {:g}",
      material.poisson_ratio);
}

constexpr std::array table{MethodEntry{.method = Method::baudet,
                                       .cells = CellShapes::cubes,
                                       .springs = on_cubes<after_baudet>,
                                       .volume_modulus = uncorrected,
                                       .refuses = with_negative_edges},
                           MethodEntry{.method = Method::nfd,
                                       .cells = CellShapes::cubes,
                                       .springs = on_cubes<without_face_diagonals>,
                                       .volume_modulus = corrected},
                           MethodEntry{.method = Method::fd,
                                       .cells = CellShapes::boxes,
                                       .springs = on_boxes,
                                       .volume_modulus = uncorrected},
                           MethodEntry{.method = Method::cf,
                                       .cells = CellShapes::boxes,
                                       .springs = on_boxes,
                                       .volume_modulus = corrected},
                           MethodEntry{.method = Method::uniform,
                                       .cells = CellShapes::cubes,
                                       .springs = on_cubes<of_one_stiffness>,
                                       .volume_modulus = uncorrected},
                           MethodEntry{.method = Method::custom,
                                       .cells = CellShapes::cubes,
                                       .springs = on_cubes<given>,
                                       .volume_modulus = corrected_as_given},
                           MethodEntry{.method = Method::affine,
                                       .cells = CellShapes::any,
                                       .springs = against_hourglasses,
                                       .volume_modulus = corrected,
                                       .has_virtual_springs = true},
                           MethodEntry{.method = Method::vangelder,
                                       .cells = CellShapes::tetrahedra,
                                       .springs = on_tetrahedra<van_gelder_stiffness>,
                                       .volume_modulus = corrected_if_on},
                           MethodEntry{.method = Method::lloyd,
                                       .cells = CellShapes::tetrahedra,
                                       .springs = on_tetrahedra<after_lloyd>,
                                       .volume_modulus = corrected_if_on}};

}  // namespace

const MethodEntry& entry_of(Method method) {
  return *std::ranges::find(table, method, &MethodEntry::method);
}

}  // namespace springcheck::mss
