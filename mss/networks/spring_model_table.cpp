#include "mss/networks/spring_model_table.hpp"

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

/// Springs between the pairs, of stiffness(pair, r) where that is not 0.
template <class Stiffness>
void add_springs(std::vector<CellSpring>& springs, const CornerPositions& x,
                 std::span<const LocalEdge> pairs, const Stiffness& stiffness) {
  for (const LocalEdge& ends : pairs) {
    const Vector3 r = along(x, ends);
    if (const double k = stiffness(ends, r); k != 0)
      springs.push_back({.ends = ends, .stiffness = k, .rest = r});
  }
}

/// stiffness(h): of the lattice of cubes with edge h.
template <class Stiffness>
std::vector<CellSpring> on_cube(const SpringCell& cell, const Stiffness& stiffness) {
  const LatticeStiffness k = stiffness(std::cbrt(cell.volume));
  std::vector<CellSpring> springs;
  const auto add = [&](std::span<const LocalEdge> pairs, double share) {
    add_springs(springs, cell.x, pairs,
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
std::vector<CellSpring> isotropic_cube(const SpringCell& cell, double diagonal_ratio) {
  return on_cube(cell, [&](double h) {
    return cell.settings.stiffness_form == StiffnessForm::shear_modulus
               ? shear_modulus_form(lame_constants(cell.material).mu, h, diagonal_ratio)
               : young_modulus_form(cell.material.young_modulus, h, diagonal_ratio);
  });
}

std::vector<CellSpring> isotropic_box(const SpringCell& cell) {
  const std::array<double, 3> box = box_edges(cell.x).value();
  if (is_cube(box)) return isotropic_cube(cell, cell.settings.diagonal_ratio);
  const double mu = cell.settings.stiffness_form == StiffnessForm::shear_modulus
                        ? lame_constants(cell.material).mu
                        : 0.4 * cell.material.young_modulus;
  return box_springs(cell.x, box_lattice(mu, box).value());
}

/// stiffness(l): of an edge of length l.
template <class Stiffness>
std::vector<CellSpring> on_tetrahedron(const SpringCell& cell,
                                       const Stiffness& stiffness) {
  std::vector<CellSpring> springs;
  add_springs(springs, cell.x, edges(CellType::tetrahedron),
              [&](const LocalEdge&, const Vector3& r) { return stiffness(r.norm()); });
  return springs;
}

std::optional<double> uncorrected(const Material& /*material*/,
                                  const NetworkSettings& /*settings*/) {
  return std::nullopt;
}

std::optional<double> corrected(const Material& material,
                                const NetworkSettings& /*settings*/) {
  return volume_correction_modulus(material);
}

std::optional<double> corrected_if_on(const Material& material,
                                      const NetworkSettings& settings) {
  if (settings.volume_correction == VolumeCorrection::off) return std::nullopt;
  return volume_correction_modulus(material);
}

std::optional<std::string> with_negative_edges(const Material& material) {
  if (material.poisson_ratio > -0.25) return std::nullopt;
  return fmt::format(
      "mss-baudet covers nu in (-0.25, 0.5): its edge stiffness is not positive at "
      "nu = {:g}",
      material.poisson_ratio);
}

constexpr std::array table{
    SpringModelEntry{.model = SpringModel::baudet,
                     .cells = CellShapes::cubes,
                     .springs =
                         [](const SpringCell& cell) {
                           return on_cube(cell, [&](double h) {
                             return baudet_stiffness(cell.material.young_modulus,
                                                     cell.material.poisson_ratio, h);
                           });
                         },
                     .volume_modulus = uncorrected,
                     .refuses = with_negative_edges},
    SpringModelEntry{
        .model = SpringModel::nfd,
        .cells = CellShapes::cubes,
        .springs = [](const SpringCell& cell) { return isotropic_cube(cell, 0); },
        .volume_modulus = corrected},
    SpringModelEntry{.model = SpringModel::fd,
                     .cells = CellShapes::boxes,
                     .springs = isotropic_box,
                     .volume_modulus = uncorrected},
    SpringModelEntry{.model = SpringModel::cf,
                     .cells = CellShapes::boxes,
                     .springs = isotropic_box,
                     .volume_modulus = corrected},
    SpringModelEntry{.model = SpringModel::uniform,
                     .cells = CellShapes::cubes,
                     .springs =
                         [](const SpringCell& cell) {
                           return on_cube(cell, [&](double h) {
                             return uniform_stiffness(cell.material.young_modulus, h);
                           });
                         },
                     .volume_modulus = uncorrected},
    SpringModelEntry{
        .model = SpringModel::custom,
        .cells = CellShapes::cubes,
        .springs =
            [](const SpringCell& cell) {
              return on_cube(cell, [&](double /*h*/) {
                return constants_of(cell.settings).stiffness;
              });
            },
        .volume_modulus = [](const Material& /*material*/,
                             const NetworkSettings& settings) -> std::optional<double> {
          const double kappa = constants_of(settings).volume_modulus;
          // hencky's volume term belongs to its springs, with any kappa.
          if (kappa == 0 && settings.strain_measure != StrainMeasure::hencky)
            return std::nullopt;
          return kappa;
        }},
    SpringModelEntry{.model = SpringModel::affine,
                     .cells = CellShapes::any,
                     .springs =
                         [](const SpringCell& cell) {
                           return hourglass_springs(cell.x, cell.volume, cell.material);
                         },
                     .volume_modulus = corrected,
                     .has_virtual_springs = true},
    SpringModelEntry{.model = SpringModel::vangelder,
                     .cells = CellShapes::tetrahedra,
                     .springs =
                         [](const SpringCell& cell) {
                           return on_tetrahedron(cell, [&](double length) {
                             return van_gelder_stiffness(cell.material.young_modulus,
                                                         cell.volume, length);
                           });
                         },
                     .volume_modulus = corrected_if_on},
    SpringModelEntry{.model = SpringModel::lloyd,
                     .cells = CellShapes::tetrahedra,
                     .springs =
                         [](const SpringCell& cell) {
                           return on_tetrahedron(cell, [&](double length) {
                             return lloyd_stiffness(cell.material.young_modulus, length);
                           });
                         },
                     .volume_modulus = corrected_if_on}};

}  // namespace

const SpringModelEntry& entry_of(SpringModel model) {
  return *std::ranges::find(table, model, &SpringModelEntry::model);
}

}  // namespace springcheck::mss
