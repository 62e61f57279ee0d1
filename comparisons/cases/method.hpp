#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "comparisons/cases/element.hpp"
#include "comparisons/cases/model.hpp"
#include "comparisons/cases/solver.hpp"
#include "comparisons/names/named.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/marching/march.hpp"
#include "dynamics/motion.hpp"
#include "meshing/loads/scene.hpp"
#include "meshing/mesh.hpp"
#include "mss/networks/network.hpp"

namespace springcheck {

struct CaseSettings;

/// The groups in which methods are presented to people.
enum class Family { springs, finite_elements, measured };

template <>
inline constexpr std::array value_names<Family>{
    Named{Family::springs, "springs"}, Named{Family::finite_elements, "finite elements"},
    Named{Family::measured, "measured"}};

/// How figures draw a method: colour as HTML, mark as matplotlib names its markers. The
/// same springs by another strain have the same mark.
struct Look {
  std::string_view colour, mark;
};

/// The compression at which a bar of a law bears its largest force, as a strain and in
/// words; 0: nowhere.
struct BarLimit {
  double strain = 0;
  std::string_view words{};
};

/// Times on one core [s]: those of an equilibrium of 10^3 cells at 5 to 20 %, means over
/// nu from 0 to .499 of the five tests; and those of a simulated second of as many cells,
/// of a regular grid or of others, at nu = .25 with steps of .9 of the limit.
struct Seconds {
  double at_rest = 0, in_motion = 0, in_motion_off_grids = 0;
};

/// The linear systems that a solution keeps in memory at most, one with `coupling` times
/// the entries of a body whose nodes meet their neighbours alone.
struct LinearSystems {
  enum class Kind { none, cholesky, conjugate_gradients, multigrid } kind = Kind::none;
  double coupling = 1;
  double multigrid_bytes = 0;  // in place of a factor, for each division of element_nodes
  double entries_per_node = 0;  // of the matrix, inside a large grid
};

/// How the steps whose time is taken are computed.
struct SteppingOptions {
  dynamics::InstructionSet instruction_set;
  int threads;
  bool by_plain_loops;  // where there is a kernel
};

/// A function that makes what steps a body through time.
using MakeMotion =
    std::function<std::unique_ptr<dynamics::Motion>(const SteppingOptions&)>;

/// A method of simulation by its name on the command line, or by the user's name for what
/// another program computed: all that tells it from others. Methods that the program has
/// are declared in comparisons/methods; nobody else asks of what kind one is.
struct Method {
  std::string name;
  std::string description{};
  std::string_view source{};
  Family family{};
  std::string_view law{};          // of the material, where the method is known by it
  std::string_view same_law_as{};  // finite elements whose law its springs follow as far
                                   // as they can
  Look look{};

  /// Settings of its own, by their keys in the table of settings. A lattice of finite
  /// elements adds its own (LatticeName).
  std::vector<std::string_view> reads{};
  std::string covers{};                       // in words; it refuses the rest in its own
  std::vector<CellType> cells{};              // it refuses others
  std::vector<Solver> solvers{};              // the first is its own; it refuses others
  bool follows_solver = true;                 // no: its own where it has not a case's
  bool is_elastic = true;                     // its material has a Young's modulus
  std::optional<double> own_poisson_ratio{};  // which it has whatever is asked for
  bool has_history = false;  // the way to a load matters without inertia too
  // Fraction of its volume that a cube loses when it is compressed by 20 % at nu = .499,
  // between glued plates; 0: not known, or a law of springs.
  double volume_lost_near_half = 0;
  bool locks = false;             // too stiff near nu = 1/2
  bool belongs_to_cells = false;  // its constants are those of the case's own cells
  bool corrects_volume = false;   // by Golec 2018, Eq. 5.36, always
  std::vector<std::string_view> refused_elements{};  // on cells of any type
  int foremost = 0;        // its place among those of its family that people want
                           // to see first, from 1; 0: behind them
  bool of_thesis = false;  // Golec's own springs, or the law he compares them with
  BarLimit bar_limit{};
  FixedSprings fixed{};  // settings of other springs that it has fixed
  // For a method that steps, the label of the other method that is its statics; without
  // an element where that is the case's own:
  std::string_view at_rest{};
  std::optional<LatticeName> lattice{};  // whose continuum fem-cauchy-born is

  /// The solution of a case. It refuses, in words, what the method does not cover. None
  /// for what another program computed. `threads` are those of steps through time.
  std::function<Solution(const CaseSettings&, const Mesh&, const Scene&, int threads,
                         const dynamics::Observers&)>
      solve{};
  /// The network of springs of a case; none where the method refuses it.
  std::function<std::optional<mss::Network>(const CaseSettings&, const Mesh&)> network{};
  /// What steps a case through time, with its precision and damping, ready to be made.
  /// Mesh and scene must outlive it.
  std::function<MakeMotion(const CaseSettings&, const Mesh&, const Scene&)> stepping{};

  Seconds seconds{};
  std::function<LinearSystems(const CaseSettings&)> linear_systems{};

  /// The method's models in charts, without their member `method`.
  std::vector<Model> charted{};
  std::vector<Omission> omits{};
  bool beside_printed = false;  // it has rows in the thesis's tables 5.1 to 5.4

  /// What keys and JSON tell of the method besides its name.
  std::vector<std::pair<std::string, std::string>> told{};
};

/// Whether a material of that Poisson's ratio is one that the method can have: any, or
/// its own to three digits.
bool has_poisson_ratio(const Method& method, double poisson_ratio);

/// Whether settings of that key are the method's own.
bool reads(const Method& method, std::string_view key);

/// Whether settings of that key are those of the case's method or finite elements, which
/// may have a lattice with settings.
bool reads(const CaseSettings& settings, std::string_view key);

}  // namespace springcheck
