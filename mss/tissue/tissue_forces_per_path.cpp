// Compiled once per instruction set.
#include "dynamics/blocks/pack_powers.hpp"
#include "mss/tissue/tissue_forces_paths.hpp"
#include "mss/tissue/tissue_shapes.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

using Tensor = std::array<P, 6>;  // symmetric: xx, yy, zz, yz, xz, xy

[[gnu::always_inline]] inline P contraction(const Tensor& a, const Tensor& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] +
         2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// F^T F of the columns of F.
[[gnu::always_inline]] inline Tensor right_cauchy_green(const Matrix& f) {
  return {dot<double>(f[0], f[0]), dot<double>(f[1], f[1]), dot<double>(f[2], f[2]),
          dot<double>(f[1], f[2]), dot<double>(f[0], f[2]), dot<double>(f[0], f[1])};
}

[[gnu::always_inline]] inline Tensor adjugate(const Tensor& c) {
  return {c[1] * c[2] - c[3] * c[3], c[0] * c[2] - c[4] * c[4],
          c[0] * c[1] - c[5] * c[5], c[4] * c[5] - c[0] * c[3],
          c[3] * c[5] - c[1] * c[4], c[3] * c[4] - c[2] * c[5]};
}

[[gnu::always_inline]] inline Matrix matrix_of(const Tensor& t) {
  return {P3{t[0], t[5], t[4]}, P3{t[5], t[1], t[3]}, P3{t[4], t[3], t[2]}};
}

/// a b, by columns.
[[gnu::always_inline]] inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      result[j][i] = a[0][i] * b[j][0] + a[1][i] * b[j][1] + a[2][i] * b[j][2];
  return result;
}

/// The strands' and the volume's part of S, see memory.hpp, summed over branches.
class Stress {
 public:
  Tensor strands{};
  P volume{};

  Stress(const TissueConstants& law, const Tensor& C, const P& growth, const P& inverse_J,
         const P& inverse_dilation)
      : law_(law),
        C_(C),
        inverse_dilation_(inverse_dilation),
        resisted_(law.bulk_ratio * growth),
        volume_part_(law.bulk_ratio * growth * growth),
        inverse_J_(inverse_J) {}

  [[gnu::always_inline]] void add(const TissueConstants::Branch& branch,
                                  const Tensor& A) {
    const P on_strands = stiffness(branch, contraction(C_, A));
    for (std::size_t i = 0; i < 6; ++i) strands[i] += on_strands * A[i];
  }

  /// Adds the elastic branch, for which A = I.
  [[gnu::always_inline]] void add_elastic(const TissueConstants::Branch& branch) {
    const P on_strands = stiffness(branch, C_[0] + C_[1] + C_[2]);
    for (std::size_t i = 0; i < 3; ++i) strands[i] += on_strands;
  }

 private:
  /// M/J^(2/3) of a branch by C : A; its part of the volume's stress is added.
  [[gnu::always_inline]] P stiffness(const TissueConstants::Branch& branch,
                                     const P& contracted) {
    const P I = contracted * inverse_dilation_ - 3;
    const P squares = larger<double>(I, P{}) + volume_part_;
    P M = all(branch.linear);
    if (branch.hardening > 0)
      M += branch.hardening * power(squares * law_.inverse_square, law_.exponent);
    volume += M * (resisted_ - (1 + I * (1. / 3)) * inverse_J_);
    return M * inverse_dilation_;
  }

  const TissueConstants& law_;
  const Tensor& C_;
  P inverse_dilation_, resisted_, volume_part_, inverse_J_;
};

template <class Shapes, bool advances>
class CellForces {
 public:
  CellForces(const TissueConstants& law, TissueBlock& block,
             const tissue::MemoryStep* step)
      : law_(law), block_(block), step_(step), shapes_(block) {}

  template <class Cells>
  [[gnu::always_inline]] void operator()(std::size_t cell, Cells& cells) const {
    const auto u = shapes_.parts(cell, read(cells, 0));
    const Matrix h = shapes_.gradient(cell, u);
    const auto [cofactor, change] = volume_of<double>(h);
    const P growth = larger<double>(change, -2 - change), J = 1 + growth;  // J = |det F|
    const P inverse_J = reciprocal<double>(J), dilation = power(J, 2. / 3);
    Matrix f = h;
    for (std::size_t i = 0; i < 3; ++i) f[i][i] += 1;
    const Tensor C = right_cauchy_green(f);
    Tensor inverse = adjugate(C);
    for (P& entry : inverse) entry *= inverse_J * inverse_J;

    const Stress stress =
        remembered(cell, inverse, dilation,
                   Stress(law_, C, growth, inverse_J, reciprocal<double>(dilation)));
    Matrix pushed = product(f, matrix_of(stress.strands));
    P trace = stress.strands[0] + stress.strands[1] + stress.strands[2];
    if (law_.viscosity > 0) {
      const Matrix rate =
          shapes_.gradient(cell, shapes_.parts(cell, read(cells, velocity)));
      const P inverse_det = change > -1. ? inverse_J : -inverse_J;
      add_dashpot(rate, cofactor, inverse_det, pushed, trace);
    }
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) pushed[j][i] += stress.volume * cofactor[j][i];
    const P mean = trace * (1. / 3);
    const Corners forces = shapes_.forces(cell, pushed, mean, u);
    for (std::size_t i = 0; i < 3; ++i) cells.add_at_corners(i, forces[i]);
  }

  /// The first field of the velocities among those that the cells read, which begin with
  /// the displacements, and the number of all.
  static constexpr std::size_t velocity = 3, read_fields = 6;

 private:
  template <class Cells>
  [[gnu::always_inline]] static Corners read(const Cells& cells, std::size_t first) {
    return {cells.at_corners(first), cells.at_corners(first + 1),
            cells.at_corners(first + 2)};
  }

  /// The address of the n-th tensor of a memory.
  [[nodiscard]] double* memory(std::size_t n, std::size_t cell) const {
    const std::size_t size = tissue_memory_size(law_.branches.size());
    return block_.memories.data() + cell * size + 6 * n * width<double>;
  }
  /// Reads the n-th tensor of a memory, and prefetches that of the next cells: large
  /// bodies' memories are in no near cache.
  [[gnu::always_inline]] Tensor memory_tensor(std::size_t n, std::size_t cell) const {
    const double* const from = memory(n, cell);
    const double* const next = memory(n, cell + width<double>);
    Tensor tensor;
    for (std::size_t i = 0; i < 6; ++i) {
      __builtin_prefetch(next + i * width<double>, 1);
      tensor[i] = load(from + i * width<double>);
    }
    return tensor;
  }
  [[gnu::always_inline]] void keep(const Tensor& tensor, std::size_t n,
                                   std::size_t cell) const {
    double* const to = memory(n, cell);
    for (std::size_t i = 0; i < 6; ++i) store(to + i * width<double>, tensor[i]);
  }

  /// The branches' stress; where it advances the memories become those after the step.
  [[gnu::always_inline]] Stress remembered(std::size_t cell, const Tensor& inverse,
                                           const P& dilation, Stress stress) const {
    stress.add_elastic(law_.elastic);
    Tensor at_rest{};
    if constexpr (advances)
      for (std::size_t i = 0; i < 6; ++i) at_rest[i] = dilation * inverse[i];
    for (std::size_t n = 0; n < law_.branches.size(); ++n) {
      Tensor A = memory_tensor(n, cell);
      if constexpr (advances) {
        const auto& [kept, from_old, from_new] = step_->decays[n];
        for (std::size_t i = 0; i < 6; ++i) A[i] = kept * A[i] + from_new * at_rest[i];
        keep(A, n, cell);
      }
      stress.add(law_.branches[n], A);
    }
    return stress;
  }

  /// Adds the dashpot's F S and tr S. With L = dF/dt F^-1 and D = (L + L^T)/2 its
  /// S = eta C^-1 dC/dt C^-1 is 2 eta F^-1 D F^-T.
  [[gnu::always_inline]] void add_dashpot(const Matrix& rate, const Matrix& cofactor,
                                          const P& inverse_det, Matrix& pushed,
                                          P& trace) const {
    Matrix F_inverse_transposed = cofactor;
    for (P3& column : F_inverse_transposed)
      for (P& entry : column) entry *= inverse_det;
    Matrix L{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
          L[j][i] += rate[k][i] * F_inverse_transposed[k][j];
    Matrix twice_D;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        twice_D[j][i] = twice_D[i][j] = law_.viscosity * (L[j][i] + L[i][j]);
    const Matrix own = product(twice_D, F_inverse_transposed);
    for (std::size_t j = 0; j < 3; ++j) {
      trace += dot<double>(own[j], F_inverse_transposed[j]);
      for (std::size_t i = 0; i < 3; ++i) pushed[j][i] += own[j][i];
    }
  }

  const TissueConstants& law_;
  TissueBlock& block_;
  const tissue::MemoryStep* step_;
  Shapes shapes_;
};

template <bool in_grid, class Shapes, bool advances>
void forces(const TissueConstants& law, TissueBlock& block,
            const tissue::MemoryStep* step, const dynamics::BlockArrays<double>& arrays) {
  using Cells = CellForces<Shapes, advances>;
  CellFields<double, Cells::read_fields, 3> fields{.from = {}, .to = arrays.force};
  for (std::size_t i = 0; i < 3; ++i) {
    fields.from[i] = arrays.displacement[i];
    fields.from[Cells::velocity + i] = arrays.velocity[i];
  }
  for_each_cell_pack<in_grid>(block.cells, arrays, fields, Cells(law, block, step));
}

template <bool in_grid, class Shapes>
TissueFunction chosen(bool advances) {
  return advances ? forces<in_grid, Shapes, true> : forces<in_grid, Shapes, false>;
}

}  // namespace

TissueFunction tissue_function(const TissueKind& kind) {
  if (kind.alike) return chosen<true, AlikeShapes>(kind.advances);
  return kind.in_grid ? chosen<true, OwnShapes>(kind.advances)
                      : chosen<false, OwnShapes>(kind.advances);
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
