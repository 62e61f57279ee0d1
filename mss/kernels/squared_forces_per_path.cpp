// Compiled once per instruction set.
#include <algorithm>

#include "dynamics/blocks/ghosts.hpp"
#include "dynamics/blocks/pack_vectors.hpp"
#include "mss/kernels/lattice_forces_paths.hpp"
#include "mss/kernels/pack_deformation.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

using namespace dynamics::SPRINGCHECK_PATH;

/// The vectors at the corners of a cell's face across x, taken together: their sum, and
/// their differences along y and along z.
template <class Real>
struct Plane {
  Pack3<Real> all{}, along_y{}, along_z{};
};

/// Forces in squared lengths on a block of boxes alike whose edges lie along the axes; x,
/// y and z are here the directions of the block. Stencil
/// (lattice_forces_per_path.cpp) goes once through the rows of lanes, with more at hand
/// than there are registers. Without roots it would wait for memory: here some rows at a
/// time are gone through once for each row that springs lead to, and once for the cells,
/// each time with little enough at hand.
template <class Real, bool face_diagonals, bool correction, bool dashpots>
class SquaredStencil {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  SquaredStencil(const LatticeBlock<Real>& block,
                 const dynamics::BlockArrays<Real>& arrays)
      : block_(block),
        arrays_(along_edges(arrays, block.along)),
        far_{0, block.row * lanes, (block.layer - block.row) * lanes, block.layer * lanes,
             (block.layer + block.row) * lanes} {}

  void run() {
    fill_ghosts(arrays_, arrays_.displacement);
    if constexpr (dashpots) {
      fill_ghosts(arrays_, arrays_.velocity);
      fill_ghosts(arrays_, std::array{arrays_.inverse_mass});
    }
    if constexpr (correction) plane_ = plane_at(arrays_.displacement, corner_rows(), 0);
    const std::size_t end = block_.rows * lanes;
    for (std::size_t first = 0; first < end; first += rows_at_a_time * lanes) {
      const std::size_t last = std::min(first + rows_at_a_time * lanes, end);
      forward(first, last);
      around<1>(first, last);
      around<2>(first, last);
      around<3>(first, last);
      around<4>(first, last);
      if constexpr (correction) correct(first, last);
    }
    subtract(end, ahead_[0]);
    for (std::size_t r = 1; r < 5; ++r) {
      subtract(end + far_[r] - lanes, there_[r]);
      subtract(end + far_[r], ahead_[r]);
    }
    if constexpr (correction) add_to_plane(arrays_.force, corner_rows(), end, pushed_);
    fold_ghosts(arrays_, arrays_.force);
  }

 private:
  static constexpr std::size_t lanes = width<Real>;
  static constexpr std::size_t rows_at_a_time = 16;  // few enough for the nearest cache

  /// Vectors' components in the order of the block's directions.
  static dynamics::BlockArrays<Real> along_edges(
      const dynamics::BlockArrays<Real>& arrays,
      const std::array<std::size_t, 3>& component) {
    dynamics::BlockArrays<Real> own = arrays;
    for (std::size_t s = 0; s < 3; ++s) {
      own.displacement[s] = arrays.displacement[component[s]];
      own.velocity[s] = arrays.velocity[component[s]];
      own.force[s] = arrays.force[component[s]];
    }
    return own;
  }

  [[gnu::always_inline]] static P3 of(const std::array<Real*, 3>& field, std::size_t at) {
    return {load(field[0] + at), load(field[1] + at), load(field[2] + at)};
  }

  [[gnu::always_inline]] void subtract(std::size_t at, const P3& forces) {
    for (std::size_t i = 0; i < 3; ++i) {
      Real* const to = arrays_.force[i] + at;
      store(to, load(to) - forces[i]);
    }
  }

  /// What all springs of one step have, and the passes' boxes and arrays: copied before a
  /// pass, since for all the compiler knows its stores might change what a reference
  /// leads to, and it would read that again in every row.
  struct Springs {
    const std::uint8_t* shares;
    std::array<Real, dynamics::largest_look_up> stiffness_of;
    Real rest_square;
  };
  Springs springs(std::size_t s) const {
    return {block_.shares[s].data(), block_.stiffness_of[s], block_.rest_square[s]};
  }

  struct Pass {
    dynamics::BlockArrays<Real> arrays;
    std::array<Real, 3> box;
    Real twice_damping_ratio;
  };
  Pass pass() const { return {arrays_, block_.box, block_.twice_damping_ratio}; }

  /// The other end of a spring that leaves the row `at` by step s to the row `to`, where
  /// the displacement is u: d and, in proportion to it, the pull factor d on the first
  /// end.
  struct Pull {
    P factor;
    P3 d;
  };
  template <std::size_t s>
  [[gnu::always_inline]] static Pull pull(const Pass& pass, const Springs& springs,
                                          std::size_t at, const P3& here, std::size_t to,
                                          const P3& u) {
    if constexpr (!face_diagonals &&
                  kind_of(lattice_steps[s]) == SpringKind::face_diagonal) {
      return {P{}, P3{}};
    } else {
      P3 d;
      for (std::size_t i = 0; i < 3; ++i)
        d[i] = u[i] - (lattice_steps[s][i] == 0   ? here[i]
                       : lattice_steps[s][i] == 1 ? here[i] - pass.box[i]
                                                  : here[i] + pass.box[i]);
      const P excess = (d[0] * d[0] - springs.rest_square) + d[1] * d[1] + d[2] * d[2];
      const P stiffness =
          looked_up<Real>(springs.stiffness_of.data(), springs.shares + at);
      P factor = stiffness * excess;
      if constexpr (dashpots) {
        const auto& velocity = pass.arrays.velocity;
        const Real* const inverse_mass = pass.arrays.inverse_mass;
        const P3 moving = of(velocity, at), v = of(velocity, to);
        P approach{};
        for (std::size_t i = 0; i < 3; ++i) approach += (v[i] - moving[i]) * d[i];
        const P inverse = load(inverse_mass + at) + load(inverse_mass + to);
        factor += dashpot<Real>(stiffness * (2 * springs.rest_square), inverse,
                                pass.twice_damping_ratio) *
                  approach * reciprocal<Real>(dot<Real>(d, d) + tiny_square<Real>);
      }
      return {factor, d};
    }
  }

  /// The springs to the next rows.
  void forward(std::size_t first, std::size_t last) {
    const Pass pass = this->pass();
    const Springs springs = this->springs(0);
    P3 here = of(pass.arrays.displacement, first), behind = ahead_[0];
    for (std::size_t at = first; at < last; at += lanes) {
      const P3 next = of(pass.arrays.displacement, at + lanes);
      const auto [factor, d] = pull<0>(pass, springs, at, here, at + lanes, next);
      for (std::size_t i = 0; i < 3; ++i) {
        Real* const force = pass.arrays.force[i] + at;
        const P pulled = factor * d[i];
        store(force, load(force) - behind[i] + pulled);
        behind[i] = pulled;
      }
      here = next;
    }
    ahead_[0] = behind;
  }

  /// The three springs to the rows about the r-th of far_.
  template <std::size_t r>
  void around(std::size_t first, std::size_t last) {
    const Pass pass = this->pass();
    const std::array<Springs, 3> springs{this->springs(3 * r - 2),
                                         this->springs(3 * r - 1), this->springs(3 * r)};
    const std::size_t far = far_[r];
    const auto& u = pass.arrays.displacement;
    P3 back = of(u, first + far - lanes), mid = of(u, first + far);
    P3 there = there_[r], ahead = ahead_[r];
    for (std::size_t at = first; at < last; at += lanes) {
      const std::size_t to = at + far;
      const P3 here = of(u, at), front = of(u, to + lanes);
      const Pull backward = pull<3 * r - 2>(pass, springs[0], at, here, to - lanes, back),
                 straight = pull<3 * r - 1>(pass, springs[1], at, here, to, mid),
                 forward = pull<3 * r>(pass, springs[2], at, here, to + lanes, front);
      // Summed so that a product and its sum are one instruction.
      for (std::size_t i = 0; i < 3; ++i) {
        Real* const force = pass.arrays.force[i];
        const P pulled = forward.factor * forward.d[i];
        store(force + at, load(force + at) + backward.factor * backward.d[i] +
                              straight.factor * straight.d[i] + pulled);
        store(force + to - lanes,
              load(force + to - lanes) - there[i] - backward.factor * backward.d[i]);
        there[i] = straight.factor * straight.d[i] + ahead[i];
        ahead[i] = pulled;
      }
      back = mid;
      mid = front;
    }
    there_[r] = there;
    ahead_[r] = ahead;
  }

  /// Elements to the rows of a face's corners.
  std::array<std::size_t, 4> corner_rows() const {
    return {far_[0], far_[1], far_[3], far_[4]};
  }

  [[gnu::always_inline]] static Plane<Real> plane_at(
      const std::array<Real*, 3>& displacement, const std::array<std::size_t, 4>& corners,
      std::size_t at) {
    std::array<P3, 4> u;
    for (std::size_t c = 0; c < 4; ++c) u[c] = of(displacement, at + corners[c]);
    Plane<Real> plane;
    for (std::size_t i = 0; i < 3; ++i) {
      const P low = u[0][i] + u[1][i], high = u[2][i] + u[3][i];
      plane.all[i] = low + high;
      plane.along_y[i] = (u[1][i] - u[0][i]) + (u[3][i] - u[2][i]);
      plane.along_z[i] = high - low;
    }
    return plane;
  }

  /// Adds a plane's forces to its corners: each of its parts acts there with the same
  /// size, as +-x, +-y and +-z.
  [[gnu::always_inline]] static void add_to_plane(
      const std::array<Real*, 3>& force, const std::array<std::size_t, 4>& corners,
      std::size_t at, const Plane<Real>& forces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const P sum = forces.along_y[i] + forces.along_z[i],
              difference = forces.along_y[i] - forces.along_z[i];
      const std::array<P, 4> of_corner{forces.all[i] - sum, forces.all[i] + difference,
                                       forces.all[i] - difference, forces.all[i] + sum};
      for (std::size_t c = 0; c < 4; ++c) {
        Real* const to = force[i] + at + corners[c];
        store(to, load(to) + of_corner[c]);
      }
    }
  }

  /// Adds the forces of the cells. With the mean edges P_s, X_s at rest, tr E = sum
  /// (P_s^2 - X_s^2)/(2 X_s^2) and f_a = -kappa V0 tr E/4 sum +-P_s/X_s^2. On each face
  /// across x what both cells do that meet there is added at once.
  void correct(std::size_t first, std::size_t last) {
    const auto displacement = arrays_.displacement, force = arrays_.force;
    const auto corners = corner_rows();
    const std::uint8_t* const is_cell = block_.is_cell.data();
    const auto trace_per_square = block_.trace_per_square,
               push_per_trace = block_.push_per_trace;
    std::array<Real, 3> fourfold_box, eightfold_box;
    for (std::size_t s = 0; s < 3; ++s) {
      fourfold_box[s] = 4 * block_.box[s];
      eightfold_box[s] = 8 * block_.box[s];
    }
    Plane<Real> plane = plane_, pushed = pushed_;
    for (std::size_t at = first; at < last; at += lanes) {
      const Plane<Real> next = plane_at(displacement, corners, at + lanes);
      std::array<P3, 3> edges;  // changes of the fourfold mean edges
      for (std::size_t i = 0; i < 3; ++i) {
        edges[0][i] = next.all[i] - plane.all[i];
        edges[1][i] = next.along_y[i] + plane.along_y[i];
        edges[2][i] = next.along_z[i] + plane.along_z[i];
      }
      plane = next;
      P trace{};
      for (std::size_t s = 0; s < 3; ++s) {
        const P squares = dot<Real>(edges[s], edges[s]) + eightfold_box[s] * edges[s][s];
        trace += trace_per_square[s] * squares;
        edges[s][s] += fourfold_box[s];
      }
      const P push = from_bytes<Real>(is_cell + at) * trace;
      const P along_x = push * push_per_trace[0], along_y = push * push_per_trace[1],
              along_z = push * push_per_trace[2];
      Plane<Real> here;
      for (std::size_t i = 0; i < 3; ++i) {
        const P x = along_x * edges[0][i], y = along_y * edges[1][i],
                z = along_z * edges[2][i];
        here.all[i] = pushed.all[i] - x;
        here.along_y[i] = pushed.along_y[i] + y;
        here.along_z[i] = pushed.along_z[i] + z;
        pushed.all[i] = x;
        pushed.along_y[i] = y;
        pushed.along_z[i] = z;
      }
      add_to_plane(force, corners, at, here);
    }
    plane_ = plane;
    pushed_ = pushed;
  }

  const LatticeBlock<Real>& block_;
  const dynamics::BlockArrays<Real> arrays_;
  const std::array<std::size_t, 5> far_;  // elements to the rows that springs lead to
  // What is kept from some rows to the next: pulls not yet taken from the rows just
  // before those that springs of the next row lead to, and from those; displacements of
  // the face at the next row, and what the cell before it does there.
  std::array<P3, 5> there_{}, ahead_{};
  Plane<Real> plane_, pushed_{};
};

template <class Real, bool face_diagonals, bool correction, bool dashpots>
void squared_forces(const LatticeBlock<Real>& block,
                    const dynamics::BlockArrays<Real>& arrays) {
  SquaredStencil<Real, face_diagonals, correction, dashpots>(block, arrays).run();
}

template <class Real, bool face_diagonals, bool correction>
LatticeForces<Real> squared(bool dashpots) {
  return dashpots ? squared_forces<Real, face_diagonals, correction, true>
                  : squared_forces<Real, face_diagonals, correction, false>;
}

template <class Real>
LatticeForces<Real> squared(const LatticeKind& kind) {
  if (kind.face_diagonals)
    return kind.correction ? squared<Real, true, true>(kind.dashpots)
                           : squared<Real, true, false>(kind.dashpots);
  return kind.correction ? squared<Real, false, true>(kind.dashpots)
                         : squared<Real, false, false>(kind.dashpots);
}

}  // namespace

LatticeForces<double> squared_lattice_forces(const LatticeKind& kind, double) {
  return squared<double>(kind);
}
LatticeForces<float> squared_lattice_forces(const LatticeKind& kind, float) {
  return squared<float>(kind);
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
