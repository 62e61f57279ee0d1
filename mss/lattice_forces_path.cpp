// Compiled once per instruction set.
#include <limits>

#include "dynamics/pack.hpp"
#include "mss/lattice_forces_paths.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

using namespace dynamics::SPRINGCHECK_PATH;

/// Below this a spring has no direction, and pulls nowhere [m^2].
template <class Real>
inline constexpr Real smallest_square = Real(1e-30);

template <class Real>
using Pack3 = std::array<Pack<Real>, 3>;

template <class Real>
[[gnu::always_inline]] inline Pack3<Real> load3(const std::array<Real*, 3>& field,
                                                std::ptrdiff_t at) {
  return {load(field[0] + at), load(field[1] + at), load(field[2] + at)};
}

template <class Real>
[[gnu::always_inline]] inline Pack<Real> dot(const Pack3<Real>& a, const Pack3<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
[[gnu::always_inline]] inline Pack3<Real> cross(const Pack3<Real>& a,
                                                const Pack3<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

/// The forces of `width` slots in a row, a register of lanes at a time, along the block.
/// A step that also goes one place sideways is summed one place off: the lanes that cross
/// into the next or the last register are kept until it is there, so that nothing is read
/// back from memory just written.
template <class Real, LatticeKind kind>
class Stencil {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  Stencil(const LatticeBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays)
      : block_(block),
        arrays_(arrays),
        row_{0, signed_of(block.row), signed_of(block.layer) - signed_of(block.row),
             signed_of(block.layer), signed_of(block.layer + block.row)} {}

  void run() {
    const auto slots = signed_of(arrays_.slots);
    for (std::ptrdiff_t at = 0; at < slots; at += lanes) step_to(at);
    for (std::size_t r = 1; r < 5; ++r)  // what the last register kept
      for (std::size_t i = 0; i < 3; ++i)
        add(arrays_.force[i] + slots - lanes + row_[r],
            -(row_sum_[r][i] + one_later<Real>(backward_[r][i], P{})));
  }

 private:
  static constexpr auto lanes = static_cast<std::ptrdiff_t>(width<Real>);
  static constexpr std::ptrdiff_t signed_of(std::size_t n) {
    return static_cast<std::ptrdiff_t>(n);
  }

  static void add(Real* to, P values) { store(to, load(to) + values); }

  /// Pull of the springs that leave the slots from `at` by step s; added to own_.
  template <std::size_t s>
  [[gnu::always_inline]] P3 pull(std::ptrdiff_t at, std::ptrdiff_t to) {
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
          d[i] += load(block_.position[i].data() + block_.reach + to) - position_[i];
      }
      const P length = reciprocal_root<Real>(
          larger<Real>(dot<Real>(d, d), all(smallest_square<Real>)));
      P k, factor;
      if constexpr (kind.alike) {
        const P shares = from_bytes<Real>(block_.shares[s].data() + at);
        k = shares * block_.stiffness[s];
        factor = shares * (block_.stiffness[s] - block_.tension[s] * length);
      } else {
        k = load(block_.stiffnesses[s].data() + at);
        factor = k - load(block_.tensions[s].data() + at) * length;
      }
      if constexpr (kind.dashpots) {
        const P3 v = load3(arrays_.velocity, to);
        P approach{};
        for (std::size_t i = 0; i < 3; ++i) approach += (v[i] - moving_[i]) * d[i];
        // c = 2 zeta sqrt(k/(1/m_a + 1/m_b)), written so that k = 0 is no division by 0.
        const P inverse =
            load(arrays_.inverse_mass + at) + load(arrays_.inverse_mass + to);
        const P c = block_.twice_damping_ratio * k *
                    reciprocal_root<Real>(
                        larger<Real>(k * inverse, all(std::numeric_limits<Real>::min())));
        factor += c * approach * length * length;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        d[i] *= factor;
        own_[i] += d[i];
      }
      return d;
    }
  }

  [[gnu::always_inline]] void step_to(std::ptrdiff_t at) {
    here_ = load3(arrays_.displacement, at);
    if constexpr (kind.dashpots) moving_ = load3(arrays_.velocity, at);
    if constexpr (!kind.alike)
      for (std::size_t i = 0; i < 3; ++i)
        position_[i] = load(block_.position[i].data() + block_.reach + at);
    own_ = {};
    std::array<P3, 4> near{}, far{};  // of the cells: corners without, with a step in x
    if constexpr (kind.correction) correct(at, near, far);

    P3 forward = pull<0>(at, at + 1);
    for (std::size_t i = 0; i < 3; ++i) {
      forward[i] -= far[0][i];
      own_[i] += near[0][i] - one_earlier<Real>(forward_[0][i], forward[i]);
    }
    forward_[0] = forward;
    row<1>(at, near[1], far[1]);
    row<2>(at, {}, {});
    row<3>(at, near[2], far[2]);
    row<4>(at, near[3], far[3]);
    for (std::size_t i = 0; i < 3; ++i) add(arrays_.force[i] + at, own_[i]);
  }

  /// The three springs to a row of nodes, and what the cells push there.
  template <std::size_t r>
  [[gnu::always_inline]] void row(std::ptrdiff_t at, const P3& near, const P3& far) {
    const std::ptrdiff_t to = at + row_[r];
    const P3 backward = pull<3 * r - 2>(at, to - 1);
    P3 straight = pull<3 * r - 1>(at, to);
    P3 forward = pull<3 * r>(at, to + 1);
    for (std::size_t i = 0; i < 3; ++i) {
      straight[i] -= near[i];
      forward[i] -= far[i];
      add(arrays_.force[i] + to - lanes,
          -(row_sum_[r][i] + one_later<Real>(backward_[r][i], backward[i])));
      row_sum_[r][i] = straight[i] + one_earlier<Real>(forward_[r][i], forward[i]);
    }
    backward_[r] = backward;
    forward_[r] = forward;
  }

  /// Forces of the cells' volume correction on their corners, by row and step in x.
  [[gnu::always_inline]] void correct(std::ptrdiff_t at, std::array<P3, 4>& near,
                                      std::array<P3, 4>& far) {
    constexpr std::array<std::size_t, 4> rows{0, 1, 3, 4};
    std::array<P3, 4> u, w;
    for (std::size_t r = 0; r < 4; ++r) {
      u[r] = r == 0 ? here_ : load3(arrays_.displacement, at + row_[rows[r]]);
      w[r] = load3(arrays_.displacement, at + row_[rows[r]] + 1);
    }
    if constexpr (kind.alike)
      correct_alike(at, u, w, near, far);
    else
      correct_varied(at, u, w, near, far);
  }

  /// With the mean edges x, y, z = rest + change: V - V0 = dx.(y x z) + dy.(z x X) +
  /// dz.(X x Y), X and Y at rest, which keeps the digits of small changes. dV/dx_a is
  /// (+-y x z +-z x x +-x x y)/4 (Golec 2018, Eq. 5.20 with the right signs).
  [[gnu::always_inline]] void correct_alike(std::ptrdiff_t at, const std::array<P3, 4>& u,
                                            const std::array<P3, 4>& w,
                                            std::array<P3, 4>& near,
                                            std::array<P3, 4>& far) {
    P3 dx, dy, dz, x, y, z, rest_x, rest_xy;
    for (std::size_t i = 0; i < 3; ++i) {
      dx[i] = Real(.25) * ((w[0][i] - u[0][i]) + (w[1][i] - u[1][i]) +
                           (w[2][i] - u[2][i]) + (w[3][i] - u[3][i]));
      dy[i] = Real(.25) * ((u[1][i] - u[0][i]) + (w[1][i] - w[0][i]) +
                           (u[3][i] - u[2][i]) + (w[3][i] - w[2][i]));
      dz[i] = Real(.25) * ((u[2][i] - u[0][i]) + (w[2][i] - w[0][i]) +
                           (u[3][i] - u[1][i]) + (w[3][i] - w[1][i]));
      rest_x[i] = all(block_.mean_edges[0][i]);
      x[i] = dx[i] + block_.mean_edges[0][i];
      y[i] = dy[i] + block_.mean_edges[1][i];
      z[i] = dz[i] + block_.mean_edges[2][i];
      rest_xy[i] = all(block_.rest_area[i]);
    }
    P3 yz = cross<Real>(y, z), zx = cross<Real>(z, x), xy = cross<Real>(x, y);
    const P change = dot<Real>(dx, yz) + dot<Real>(dy, cross<Real>(z, rest_x)) +
                     dot<Real>(dz, rest_xy);
    const P push = from_bytes<Real>(block_.is_cell.data() + at) *
                   (Real(-.25) * block_.pressure_per_volume) * change;
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

  /// H = sum u_a (x) G_a, f_a = -V kappa (det F - 1) cof F G_a.
  [[gnu::always_inline]] void correct_varied(std::ptrdiff_t at,
                                             const std::array<P3, 4>& u,
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
    std::array<P3, 3> f = h;
    for (std::size_t i = 0; i < 3; ++i) f[i][i] += Real(1);
    const std::array<P3, 3> cofactor{cross<Real>(f[1], f[2]), cross<Real>(f[2], f[0]),
                                     cross<Real>(f[0], f[1])};
    // det F - 1 as above, the edges at rest being the unit vectors.
    const P change =
        dot<Real>(h[0], cofactor[0]) + (h[1][1] * f[2][2] - h[1][2] * f[2][1]) + h[2][2];
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
  const std::array<std::ptrdiff_t, 5> row_;  // offsets; the rows after the slot's own
  P3 here_, moving_, position_, own_;
  std::array<P3, 5> forward_{}, backward_{}, row_sum_{};
};

template <class Real, LatticeKind kind>
void forces(const LatticeBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays) {
  Stencil<Real, kind>(block, arrays).run();
}

/// The kernel compiled for `kind`: the flags in turn become template arguments.
template <class Real, bool... flags>
LatticeForces<Real> choose(const LatticeKind& kind) {
  constexpr std::size_t count = sizeof...(flags);
  if constexpr (count == 4) {
    constexpr std::array<bool, 4> all_flags{flags...};
    return forces<Real,
                  LatticeKind{all_flags[0], all_flags[1], all_flags[2], all_flags[3]}>;
  } else {
    const std::array<bool, 4> wanted{kind.alike, kind.face_diagonals, kind.correction,
                                     kind.dashpots};
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
