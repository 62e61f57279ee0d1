#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/cases/grids.hpp"
#include "comparisons/studies/converged.hpp"

namespace springcheck {

/// The error of springs against a continuum law, in two parts:
///
///     law             converged Cauchy-Born - converged reference law
///     discretisation  springs on this mesh  - converged Cauchy-Born
///
/// Cauchy-Born is the continuum of the springs' own lattice: what they would converge to.
/// Both continua are converged by extrapolation over q1-sri on the springs' cells and on
/// 2 and 4 times as many along each axis, and checked by a second discretisation, q2 on
/// half, once and twice as many.
struct SplitPlan {
  CaseSettings springs;
  ThreeCases cauchy_born, cauchy_born_check;
  ThreeCases reference, reference_check;
};

/// What springs of a lattice (Method::lattice) would converge to, by q1-sri on the cells
/// of the case.
CaseSettings continuum_of(const CaseSettings& springs);

/// The plan of a split. Throws InputError unless `law` is one of finite elements, and
/// fem-cauchy-born knows the springs' lattice.
SplitPlan plan_split(const CaseSettings& springs, const Method& law);

/// The simulations of the continua, in the order in which split_error takes their
/// results.
std::vector<Request> split_requests(const SplitPlan& plan);

/// A quantity on one grid; empty where the run failed.
struct GridValue {
  Cells cells;
  std::string key;  // of its case in the result file
  std::optional<double> value;
};

/// A quantity on three grids, from coarse to fine, and what it converges to.
struct ConvergedValue {
  std::vector<GridValue> grids;
  std::optional<double> value{}, order{}, error_bound{};  // no order: none was observed
};

/// A quantity of one continuum by both discretisations.
struct ContinuumValue {
  ConvergedValue converged;  // q1-sri; its error bound is at least the disagreement
  ConvergedValue check;      // q2
  // The distance between the two: |value - value|, or the mean distance of the fields.
  std::optional<double> disagreement{};
  // Whether the two agree within the sum of the error bounds of their grids, and all runs
  // are ok.
  bool is_resolved;
};

/// A part of the error, and its error bound. The bound of the discretisation part is
/// Cauchy-Born's. Both continua err nearly alike on equal grids: the error bound of a law
/// part is that of their difference, extrapolated grid by grid (converged_difference),
/// and its distance from the part; it is at least the part's distance from the one that
/// q2's grids give. For fields it is the sum of both error bounds.
struct ErrorPart {
  std::optional<double> value{}, error_bound{};
};

/// One quantity, split. For fields ("mean_deviation") the numbers are mean distances over
/// the nodes of the springs' mesh: from the converged reference law, but for the
/// discretisation part, which is the springs' distance from the converged Cauchy-Born.
/// Those parts do not add up to the springs' number; they bound it.
struct SplitQuantity {
  std::string name;  // of the measure
  std::optional<double> springs;
  ContinuumValue cauchy_born, reference;
  ErrorPart law{}, discretisation{};

  /// Whether both continua are resolved and the springs have a value.
  [[nodiscard]] bool is_resolved() const;
};

struct Split {
  SplitPlan plan;
  std::vector<SplitQuantity> quantities{};  // volume change, answer to the load, field
  std::vector<std::string> reasons{};       // runs that are not "ok", in words
};

/// A number that is split, by the name of its measure.
struct SplitMeasure {
  std::string name;
  std::function<std::optional<double>(const Measures&)> of;
};

/// The answer to the load: the plate's force, in shearing its resultant, in torsion its
/// torque; the tip's drop in bending, the length of the face's displacement in traction;
/// none in affine, where the fields agree by construction.
std::optional<SplitMeasure> answer_to_load(Test test);

/// Splits the springs' error; `runs` are the results of split_requests, with fields.
Split split_error(const SplitPlan& plan, const CaseResult& springs,
                  std::span<const CaseResult> runs, MeshStore& meshes);

}  // namespace springcheck
