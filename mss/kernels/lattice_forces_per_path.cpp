// Compiled once per instruction set.
#include "dynamics/blocks/ghosts.hpp"
#include "dynamics/blocks/pack_vectors.hpp"
#include "mss/kernels/lattice_forces_paths.hpp"
#include "mss/kernels/pack_deformation.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

using namespace dynamics::SPRINGCHECK_PATH;

template <class Real>
[[gnu::always_inline]] inline Pack3<Real> load3(const std::array<Real*, 3>& field,
                                                std::size_t at) {
  return {load(field[0] + at), load(field[1] + at), load(field[2] + at)};
}

/// The forces on a block, except for alike boxes in squared lengths, a row of its lanes
/// at a time. Springs and cells lead from a row to the next one and to those about a row,
/// a layer and their sum of the grid further on. What they do to three neighbouring rows
/// there is kept in registers until the last of their sources is reached, and then
/// written once.
template <class Real, LatticeKind kind>
class Stencil {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  Stencil(const LatticeBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays)
      : block_(block),
        arrays_(arrays),
        far_{0, block.row * lanes, (block.layer - block.row) * lanes, block.layer * lanes,
             (block.layer + block.row) * lanes} {}

  void run() {
    fill_ghosts(arrays_, arrays_.displacement);
    if constexpr (kind.dashpots) {
      fill_ghosts(arrays_, arrays_.velocity);
      fill_ghosts(arrays_, std::array{arrays_.inverse_mass});
    }
    const std::size_t end = block_.rows * lanes;
    for (std::size_t at = 0; at < end; at += lanes) forces_from(at);
    subtract(end, next_[0]);
    for (std::size_t r = 1; r < 5; ++r) {
      subtract(end + far_[r] - lanes, now_[r]);
      subtract(end + far_[r], next_[r]);
    }
    fold_ghosts(arrays_, arrays_.force);
  }

 private:
  static constexpr std::size_t lanes = width<Real>;

  [[gnu::always_inline]] void subtract(std::size_t at, const P3& forces) {
    for (std::size_t i = 0; i < 3; ++i) {
      Real* const to = arrays_.force[i] + at;
      store(to, load(to) - forces[i]);
    }
  }

  /// The pull of the springs that leave the row `at` by step s to the row `to`; it is
  /// added to own_.
  template <std::size_t s>
  [[gnu::always_inline]] P3 pull(std::size_t at, std::size_t to) {
    if constexpr (!kind.face_diagonals &&
                  kind_of(lattice_steps[s]) == SpringKind::face_diagonal) {
      return {};
    } else {
      const P3 u = load3(arrays_.displacement, to);
      P3 d;
      for (std::size_t i = 0; i < 3; ++i) {
        d[i] = u[i] - here_[i];
        if constexpr (kind.alike)
          d[i] += block_.rest[s][i];
        else
          d[i] += load(block_.position[i].data() + to) - position_[i];
      }
      const P square = (d[0] * d[0] + tiny_square<Real>)+d[1] * d[1] + d[2] * d[2];
      P inverse_length;
      if constexpr (!kind.squared || kind.dashpots)
        inverse_length = reciprocal_root<Real>(square);
      P k, factor;
      if constexpr (kind.alike) {
        const P shares = from_bytes<Real>(block_.shares[s].data() + at);
        k = shares * block_.stiffness[s];
        factor = shares * (block_.stiffness[s] - block_.tension[s] * inverse_length);
      } else if constexpr (kind.squared) {
        const P half = load(block_.tensions[s].data() + at);
        k = 2 * half;
        factor = load(block_.stiffnesses[s].data() + at) * square - half;
      } else {
        k = load(block_.stiffnesses[s].data() + at);
        factor = k - load(block_.tensions[s].data() + at) * inverse_length;
      }
      if constexpr (kind.dashpots) {
        const P3 v = load3(arrays_.velocity, to);
        P approach{};
        for (std::size_t i = 0; i < 3; ++i) approach += (v[i] - moving_[i]) * d[i];
        const P inverse =
            load(arrays_.inverse_mass + at) + load(arrays_.inverse_mass + to);
        const P c = dashpot<Real>(k, inverse, block_.twice_damping_ratio);
        factor += c * approach * inverse_length * inverse_length;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        d[i] *= factor;
        own_[i] += d[i];
      }
      return d;
    }
  }

  [[gnu::always_inline]] void forces_from(std::size_t at) {
    here_ = load3(arrays_.displacement, at);
    if constexpr (kind.dashpots) moving_ = load3(arrays_.velocity, at);
    if constexpr (!kind.alike)
      for (std::size_t i = 0; i < 3; ++i)
        position_[i] = load(block_.position[i].data() + at);
    own_ = {};
    std::array<P3, 4> near{}, far{};  // of the cells: corners without, with a step in x
    if constexpr (kind.correction) correct(at, near, far);

    const P3 forward = pull<0>(at, at + lanes);
    around<1>(at, near[1], far[1]);
    around<2>(at, {}, {});
    around<3>(at, near[2], far[2]);
    around<4>(at, near[3], far[3]);
    P3 all_of_it;
    for (std::size_t i = 0; i < 3; ++i) {
      all_of_it[i] = next_[0][i] - own_[i] - near[0][i];
      next_[0][i] = forward[i] - far[0][i];
    }
    subtract(at, all_of_it);
  }

  /// The three springs to the rows about the r-th of far_, and what the cells push there.
  template <std::size_t r>
  [[gnu::always_inline]] void around(std::size_t at, const P3& near, const P3& far) {
    const std::size_t to = at + far_[r];
    const P3 backward = pull<3 * r - 2>(at, to - lanes);
    const P3 straight = pull<3 * r - 1>(at, to);
    const P3 forward = pull<3 * r>(at, to + lanes);
    P3 done;
    for (std::size_t i = 0; i < 3; ++i) {
      done[i] = now_[r][i] + backward[i];
      now_[r][i] = next_[r][i] + straight[i] - near[i];
      next_[r][i] = forward[i] - far[i];
    }
    subtract(to - lanes, done);
  }

  /// Forces of the cells' volume correction on their corners, by row and step in x.
  [[gnu::always_inline]] void correct(std::size_t at, std::array<P3, 4>& near,
                                      std::array<P3, 4>& far) {
    constexpr std::array<std::size_t, 4> rows{0, 1, 3, 4};
    std::array<P3, 4> u, w;
    for (std::size_t r = 0; r < 4; ++r) {
      u[r] = r == 0 ? here_ : load3(arrays_.displacement, at + far_[rows[r]]);
      w[r] = load3(arrays_.displacement, at + far_[rows[r]] + lanes);
    }
    if constexpr (kind.alike)
      correct_alike(at, u, w, near, far);
    else
      correct_varied(at, u, w, near, far);
  }

  /// The correction of alike cells with the mean edges x, y, z = rest + change: V - V0 =
  /// dx.(y x z) + dy.(z x X) + dz.(X x Y), X and Y at rest, which keeps the digits of
  /// small changes. dV/dx_a is (+-y x z +-z x x +-x x y)/4 (Golec 2018, Eq. 5.20 with the
  /// right signs).
  [[gnu::always_inline]] void correct_alike(std::size_t at, const std::array<P3, 4>& u,
                                            const std::array<P3, 4>& w,
                                            std::array<P3, 4>& near,
                                            std::array<P3, 4>& far) {
    P3 dx, dy, dz, x, y, z, rest_x, rest_xy;  // four times the mean edges
    for (std::size_t i = 0; i < 3; ++i) {
      const P low_0 = u[0][i] + w[0][i], low_1 = u[1][i] + w[1][i],
              high_0 = u[2][i] + w[2][i], high_1 = u[3][i] + w[3][i];
      dx[i] = (w[0][i] - u[0][i]) + (w[1][i] - u[1][i]) + (w[2][i] - u[2][i]) +
              (w[3][i] - u[3][i]);
      dy[i] = (low_1 - low_0) + (high_1 - high_0);
      dz[i] = (high_0 - low_0) + (high_1 - low_1);
      rest_x[i] = all(block_.fourfold_edges[0][i]);
      x[i] = dx[i] + block_.fourfold_edges[0][i];
      y[i] = dy[i] + block_.fourfold_edges[1][i];
      z[i] = dz[i] + block_.fourfold_edges[2][i];
      rest_xy[i] = all(block_.sixteenfold_area[i]);
    }
    P3 yz = cross<Real>(y, z), zx = cross<Real>(z, x), xy = cross<Real>(x, y);
    const P change = dot<Real>(dx, yz) + dot<Real>(dy, cross<Real>(z, rest_x)) +
                     dot<Real>(dz, rest_xy);
    const P push =
        from_bytes<Real>(block_.is_cell.data() + at) * block_.push_per_change * change;
    for (std::size_t i = 0; i < 3; ++i) {
      const P a = push * yz[i], sum = push * (zx[i] + xy[i]),
              difference = push * (zx[i] - xy[i]);
      near[0][i] = -a - sum;
      far[0][i] = a - sum;
      near[1][i] = difference - a;
      far[1][i] = difference + a;
      near[2][i] = -a - difference;
      far[2][i] = a - difference;
      near[3][i] = sum - a;
      far[3][i] = sum + a;
    }
  }

  /// The correction of cells that differ: H = sum u_a (x) G_a, f_a = -V kappa (det F - 1)
  /// cof F G_a.
  [[gnu::always_inline]] void correct_varied(std::size_t at, const std::array<P3, 4>& u,
                                             const std::array<P3, 4>& w,
                                             std::array<P3, 4>& near,
                                             std::array<P3, 4>& far) {
    std::array<P3, 3> h{};  // columns of H
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t r = 0; r < 4; ++r) {
        const P g = load(block_.gradients[j][2 * r].data() + at),
                e = load(block_.gradients[j][2 * r + 1].data() + at);
        for (std::size_t i = 0; i < 3; ++i) h[j][i] += u[r][i] * g + w[r][i] * e;
      }
    const auto [cofactor, change] = kind.squared ? trace_of<Real>(h) : volume_of<Real>(h);
    const P push =
        -block_.volume_modulus * load(block_.cell_volumes.data() + at) * change;
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t j = 0; j < 3; ++j) {
        const P g = push * load(block_.gradients[j][2 * r].data() + at),
                e = push * load(block_.gradients[j][2 * r + 1].data() + at);
        for (std::size_t i = 0; i < 3; ++i) {
          near[r][i] += cofactor[j][i] * g;
          far[r][i] += cofactor[j][i] * e;
        }
      }
  }

  const LatticeBlock<Real>& block_;
  const dynamics::BlockArrays<Real>& arrays_;
  const std::array<std::size_t, 5> far_;  // elements to the rows that springs lead to
  P3 here_, moving_, position_, own_;
  // Forces not yet written: on the rows just before `at` + far_ and on those there.
  std::array<P3, 5> now_{}, next_{};
};

template <class Real, LatticeKind kind>
void forces(const LatticeBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays) {
  Stencil<Real, kind>(block, arrays).run();
}

/// The kernel compiled for `kind`: the flags in turn become template arguments.
template <class Real, bool... flags>
LatticeForces<Real> choose(const LatticeKind& kind) {
  constexpr std::size_t count = sizeof...(flags);
  if constexpr (count == 5) {
    constexpr std::array<bool, 5> all_flags{flags...};
    constexpr LatticeKind known{all_flags[0], all_flags[1], all_flags[2], all_flags[3],
                                all_flags[4]};
    if constexpr (known.alike && known.squared)
      return squared_lattice_forces(kind, Real{});
    else
      return forces<Real, known>;
  } else {
    const std::array<bool, 5> wanted{kind.alike, kind.squared, kind.face_diagonals,
                                     kind.correction, kind.dashpots};
    return wanted[count] ? choose<Real, flags..., true>(kind)
                         : choose<Real, flags..., false>(kind);
  }
}

}  // namespace

LatticeForces<double> lattice_forces(const LatticeKind& kind, double) {
  return choose<double>(kind);
}
LatticeForces<float> lattice_forces(const LatticeKind& kind, float) {
  return choose<float>(kind);
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
