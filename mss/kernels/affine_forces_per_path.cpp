// Compiled once per instruction set.
#include <array>
#include <limits>

#include "dynamics/blocks/cell_packs.hpp"
#include "mss/kernels/affine_forces_paths.hpp"
#include "mss/kernels/affine_shapes.hpp"
#include "mss/kernels/virtual_springs_stress.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

template <class Real, AffineKind kind>
class CellForces {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  explicit CellForces(const AffineBlock<Real>& block) : block_(block), shapes_(block) {}

  /// The first fields of the velocities and of the pressures among those that the cells
  /// read, which begin with the displacements, and the number of all.
  static constexpr std::size_t velocity = 3, pressure = kind.dashpots ? 6 : 3,
                               read = pressure + (kind.patches ? 1 : 0);

  template <class Cells>
  [[gnu::always_inline]] void operator()(std::size_t cell, Cells& cells) const {
    Corners<Real> u, v, f{};
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = cells.at_corners(i);
      if constexpr (kind.dashpots) v[i] = cells.at_corners(velocity + i);
    }
    const PackMatrix<Real> h = shapes_.displacement_gradient(cell, u);
    PackMatrix<Real> stress{};  // V P
    const P volume = shapes_.volume(cell);
    if constexpr (kind.squared)
      add_st_venant_stress<Real>(h, volume * block_.axis_modulus, stress);
    else
      add_axis_stress<Real>(h, volume, block_, stress);
    if (kind.patches || block_.volume_modulus != 0) {
      const auto [cofactor, change] =
          kind.squared ? trace_of<Real>(h) : volume_of<Real>(h);
      P push{};
      if constexpr (kind.patches) {
        for (const P part : cells.at_corners(pressure)) push += part;
      } else {
        push = block_.volume_modulus * change;
      }
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
          stress[j][i] += volume * push * cofactor[j][i];
    }
    shapes_.add_forces(
        cell, h, stress, u, f,
        [&](std::size_t s, const P& stiffness, const AffineRest<Real>& rest)
            __attribute__((always_inline)) {
              return pull(cell, s, stiffness, rest, u, v, f);
            });
    for (std::size_t i = 0; i < 3; ++i) cells.add_at_corners(i, f[i]);
  }

 private:
  /// Adds k (l - L) d/l to the forces, with the lengths l and L = |F r|, and returns k (l
  /// - L)/L; in squared lengths it adds t d and returns t = k/(2 r^2) (l^2 - L^2). The
  /// form l - L = w.(d + F r)/(l + L), w = d - F r, keeps the digits of small
  /// differences; 1/(l^2 + l L) and 1/(L^2 + l L) come of one reciprocal.
  [[gnu::always_inline]] P pull(std::size_t cell, std::size_t s, const P& stiffness,
                                const AffineRest<Real>& rest, const Corners<Real>& u,
                                const Corners<Real>& v, Corners<Real>& f) const {
    const auto [a, b] = affine_springs[s];
    P3 d;
    P excess{};
    for (std::size_t i = 0; i < 3; ++i) {
      const P w = u[i][b] - u[i][a] - rest.move[i];
      d[i] = rest.vector[i] + w;
      excess += w * (d[i] + rest.vector[i]);
    }
    constexpr Real least = std::numeric_limits<Real>::min();
    const P square = dot<Real>(d, d) + tiny_square<Real>;
    P factor, taken;
    if constexpr (kind.squared) {
      factor = taken = stiffness * excess;
    } else {
      const P squares = square * rest.square;
      const P both = squares * reciprocal_root<Real>(larger<Real>(squares, all(least)));
      const P first = square + both, second = rest.square + both;
      const P tension =
          stiffness * excess * reciprocal<Real>(larger<Real>(first * second, all(least)));
      factor = tension * second;
      taken = tension * first;
    }
    if constexpr (kind.dashpots)
      if (s < 12) {
        P approach{};
        for (std::size_t i = 0; i < 3; ++i) approach += (v[i][b] - v[i][a]) * d[i];
        factor += load(block_.dashpots.data() + s * block_.cells.count + cell) *
                  approach * reciprocal<Real>(square);
      }
    for (std::size_t i = 0; i < 3; ++i) {
      const P along = factor * d[i];
      f[i][a] += along;
      f[i][b] -= along;
    }
    return taken;
  }

  const AffineBlock<Real>& block_;
  AffineShapes<Real, kind.alike> shapes_;
};

template <class Real, AffineKind kind>
void forces(const AffineBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays) {
  using Cells = CellForces<Real, kind>;
  CellFields<Real, Cells::read, 3> fields{.from = {}, .to = arrays.force};
  for (std::size_t i = 0; i < 3; ++i) {
    fields.from[i] = arrays.displacement[i];
    if constexpr (kind.dashpots) fields.from[Cells::velocity + i] = arrays.velocity[i];
  }
  if constexpr (kind.patches) {
    for (std::size_t s = 0; s < arrays.rows * arrays.lanes; s += width<Real>)
      store(arrays.nodal_sum + s,
            load(arrays.nodal_sum + s) * load(block.pressure_per_sum.data() + s));
    fields.from[Cells::pressure] = arrays.nodal_sum;
  }
  for_each_cell_pack<kind.in_grid>(block.cells, arrays, fields, Cells(block));
}

/// The sums over cells of V t, t the change of volume.
template <class Real, bool in_grid, bool alike, bool squared>
void volume_sums(const AffineBlock<Real>& block,
                 const dynamics::BlockArrays<Real>& arrays) {
  const CellFields<Real, 3, 1> fields{.from = arrays.displacement,
                                      .to = {arrays.nodal_sum}};
  const AffineShapes<Real, alike> shapes(block);
  for_each_cell_pack<
      in_grid>(block.cells, arrays, fields, [&](std::size_t cell, auto& cells) {
    const Corners<Real> u{cells.at_corners(0), cells.at_corners(1), cells.at_corners(2)};
    const PackMatrix<Real> h = shapes.displacement_gradient(cell, u);
    CornerPacks<Real> change;
    change.fill(shapes.volume(cell) *
                (squared ? trace_of<Real>(h) : volume_of<Real>(h)).change);
    cells.add_at_corners(0, change);
  });
}

/// The functions compiled for `kind`: the flags in turn become template arguments.
template <class Real, bool... flags>
AffineFunctions<Real> choose(const AffineKind& kind) {
  constexpr std::size_t count = sizeof...(flags);
  if constexpr (count == 5) {
    constexpr std::array<bool, 5> all_flags{flags...};
    constexpr AffineKind known{all_flags[0], all_flags[0] && all_flags[1], all_flags[2],
                               all_flags[3], all_flags[4]};  // only grids have alike ones
    AffineFunctions<Real> functions{.forces = forces<Real, known>,
                                    .volume_sums = nullptr};
    if constexpr (known.patches)
      functions.volume_sums =
          volume_sums<Real, known.in_grid, known.alike, known.squared>;
    return functions;
  } else {
    const std::array<bool, 5> wanted{kind.in_grid, kind.alike, kind.patches, kind.squared,
                                     kind.dashpots};
    return wanted[count] ? choose<Real, flags..., true>(kind)
                         : choose<Real, flags..., false>(kind);
  }
}

}  // namespace

AffineFunctions<double> affine_functions(const AffineKind& kind, double) {
  return choose<double>(kind);
}
AffineFunctions<float> affine_functions(const AffineKind& kind, float) {
  return choose<float>(kind);
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
