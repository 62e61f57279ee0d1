#include "comparisons/studies/split.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "comparisons/methods/methods.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

using Runs = std::span<const CaseResult>;  // one continuum, one discretisation

/// Half, once and twice as many cells; once, twice and four times where one cell cannot
/// be halved.
ThreeCases check_grids(const CaseSettings& settings) {
  CaseSettings q2 = settings;
  q2.elements.element = *find_element("q2");
  if (std::ranges::count(settings.body.block.cells, 1) > 0) return convergence_grids(q2);
  ThreeCases grids{q2, q2, q2};
  grids[0].body.block.cells = coarsened(q2.body.block.cells);
  grids[2].body.block.cells = refined(q2.body.block.cells, 2);
  return grids;
}

ThreeCases cases_of(Runs runs) {
  return {runs[0].request.settings, runs[1].request.settings, runs[2].request.settings};
}

/// The values of a measure on the grids.
template <class Of>
std::vector<GridValue> on_grids(Runs runs, Of&& of) {
  std::vector<GridValue> grids;
  for (const CaseResult& run : runs)
    grids.push_back({run.request.settings.body.block.cells, run.key, of(run)});
  return grids;
}

/// The values of all three grids; none where a run failed.
std::optional<std::array<double, 3>> values_of(const ConvergedValue& value) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!value.grids[i].value) return std::nullopt;
    values[i] = *value.grids[i].value;
  }
  return values;
}

/// A scalar measure; changes below solver_noise times its unit, or times its own value,
/// are the solvers'.
ConvergedValue converged_measure(Runs runs, const SplitMeasure& measure,
                                 const std::optional<double>& unit) {
  ConvergedValue value{.grids = on_grids(runs, [&](const CaseResult& run) {
                         return measure.of(run.measures);
                       })};
  const auto values = values_of(value);
  if (!values) return value;
  const ConvergedNumber limit = converged_number(
      cases_of(runs), *values, solver_noise * unit.value_or(std::abs((*values)[2])));
  value.value = limit.value;
  value.order = limit.order;
  value.error_bound = limit.error_bound;
  return value;
}

bool all_ok(Runs runs, Runs check) {
  const auto is_ok = [](const CaseResult& run) { return run.status == Status::ok; };
  return std::ranges::all_of(runs, is_ok) && std::ranges::all_of(check, is_ok);
}

/// Holds what one discretisation converges to against the other.
ContinuumValue checked(ConvergedValue converged, ConvergedValue check,
                       const std::optional<double>& disagreement, bool all_ok) {
  ContinuumValue both{.converged = std::move(converged),
                      .check = std::move(check),
                      .disagreement = disagreement,
                      .is_resolved = false};
  if (!disagreement) return both;
  double& error_bound = both.converged.error_bound.value();
  both.is_resolved =
      all_ok && *disagreement <= error_bound + both.check.error_bound.value();
  error_bound = std::max(error_bound, *disagreement);
  return both;
}

ContinuumValue continuum_measure(Runs runs, Runs check, const SplitMeasure& measure,
                                 const std::optional<double>& unit) {
  ConvergedValue by_runs = converged_measure(runs, measure, unit),
                 by_check = converged_measure(check, measure, unit);
  std::optional<double> disagreement;
  if (by_runs.value && by_check.value)
    disagreement = std::abs(*by_runs.value - *by_check.value);
  return checked(std::move(by_runs), std::move(by_check), disagreement,
                 all_ok(runs, check));
}

std::optional<double> difference(const std::optional<double>& a,
                                 const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return *a - *b;
}

std::optional<double> sum(const std::optional<double>& a,
                          const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return *a + *b;
}

/// A converged field, where all the runs it needs gave one.
std::optional<ConvergedField> field_of(Runs runs, const Body& body, MeshStore& meshes) {
  std::vector<const CaseResult*> usable;
  for (const CaseResult& run : runs)
    if (is_refinement(run.request.settings.body.block.cells, body.block.cells))
      usable.push_back(&run);
  for (const CaseResult* run : usable)
    if (!run->measures.volume_error) return std::nullopt;
  return usable.size() == 3 ? converged_field(usable, body, meshes)
                            : finest_field(usable, body, meshes);
}

std::optional<double> mean_distance(const std::vector<Vector3>& a,
                                    const std::optional<ConvergedField>& b) {
  if (!b || a.empty()) return std::nullopt;
  double total = 0;
  for (std::size_t n = 0; n < a.size(); ++n) total += (a[n] - b->displacements[n]).norm();
  return total / static_cast<double>(a.size());
}

std::optional<double> mean_distance(const std::optional<ConvergedField>& a,
                                    const std::optional<ConvergedField>& b) {
  if (!a) return std::nullopt;
  return mean_distance(a->displacements, b);
}

/// Distances of a continuum's fields from `origin`.
ConvergedValue converged_distance(Runs runs, const std::optional<ConvergedField>& field,
                                  const std::optional<ConvergedField>& origin,
                                  const Body& body, MeshStore& meshes) {
  ConvergedValue value{
      .grids = on_grids(
          runs,
          [&](const CaseResult& run) -> std::optional<double> {
            const Cells& own = run.request.settings.body.block.cells;
            if (!run.measures.volume_error || !is_refinement(own, body.block.cells))
              return std::nullopt;
            return mean_distance(displacements_on(body, run, meshes), origin);
          }),
      .value = mean_distance(field, origin)};
  if (field) {
    value.order = field->order;
    value.error_bound = field->error_bound;
  }
  return value;
}

struct ContinuumRuns {
  Runs runs, check;
};

/// What the difference of two continua converges to, grid by grid, in the law's cases.
std::optional<ConvergedNumber> between_continua(const ConvergedValue& lattice,
                                                const ConvergedValue& law, Runs runs,
                                                const std::optional<double>& unit) {
  const auto springs = values_of(lattice), elements = values_of(law);
  if (!springs || !elements) return std::nullopt;
  std::array<double, 3> differences{};
  for (std::size_t i = 0; i < 3; ++i) differences[i] = (*springs)[i] - (*elements)[i];
  return converged_difference(cases_of(runs), differences,
                              solver_noise * unit.value_or(std::abs((*elements)[2])));
}

/// The law part with its error bound (ErrorPart).
ErrorPart law_part(const SplitQuantity& quantity, const ContinuumRuns& reference,
                   const std::optional<double>& unit) {
  const auto of = [&](auto which, Runs runs) {
    return between_continua(quantity.cauchy_born.*which, quantity.reference.*which, runs,
                            unit);
  };
  ErrorPart part{difference(quantity.cauchy_born.converged.value,
                            quantity.reference.converged.value)};
  const auto by_grids = of(&ContinuumValue::converged, reference.runs),
             by_check = of(&ContinuumValue::check, reference.check);
  if (part.value && by_grids && by_check)
    part.error_bound =
        std::max(by_grids->error_bound + std::abs(by_grids->value - *part.value),
                 std::abs(by_check->value - *part.value));
  return part;
}

SplitQuantity split_measure(const SplitMeasure& measure,
                            const std::optional<double>& unit, const CaseResult& springs,
                            const ContinuumRuns& cauchy_born,
                            const ContinuumRuns& reference) {
  SplitQuantity quantity{
      .name = measure.name,
      .springs = measure.of(springs.measures),
      .cauchy_born =
          continuum_measure(cauchy_born.runs, cauchy_born.check, measure, unit),
      .reference = continuum_measure(reference.runs, reference.check, measure, unit)};
  const ConvergedValue& lattice = quantity.cauchy_born.converged;
  quantity.law = law_part(quantity, reference, unit);
  quantity.discretisation = {difference(quantity.springs, lattice.value),
                             lattice.error_bound};
  return quantity;
}

SplitQuantity split_field(const CaseResult& springs, const ContinuumRuns& cauchy_born,
                          const ContinuumRuns& reference, MeshStore& meshes) {
  const Body& body = springs.request.settings.body;
  const auto lattice = field_of(cauchy_born.runs, body, meshes);
  const auto lattice_check = field_of(cauchy_born.check, body, meshes);
  const auto law = field_of(reference.runs, body, meshes);
  const auto law_check = field_of(reference.check, body, meshes);
  const std::vector<Vector3> own = springs.measures.volume_error
                                       ? springs.solution.displacements
                                       : std::vector<Vector3>{};
  SplitQuantity quantity{
      .name = "mean_deviation",
      .springs = mean_distance(own, law),
      .cauchy_born =
          checked(converged_distance(cauchy_born.runs, lattice, law, body, meshes),
                  converged_distance(cauchy_born.check, lattice_check, law, body, meshes),
                  mean_distance(lattice, lattice_check),
                  all_ok(cauchy_born.runs, cauchy_born.check)),
      .reference = checked(
          converged_distance(reference.runs, law, law, body, meshes),
          converged_distance(reference.check, law_check, law, body, meshes),
          mean_distance(law, law_check), all_ok(reference.runs, reference.check))};
  const auto& lattice_error_bound = quantity.cauchy_born.converged.error_bound;
  quantity.law = {mean_distance(lattice, law),
                  sum(lattice_error_bound, quantity.reference.converged.error_bound)};
  quantity.discretisation = {mean_distance(own, lattice), lattice_error_bound};
  return quantity;
}

}  // namespace

CaseSettings continuum_of(const CaseSettings& springs) {
  CaseSettings continuum = without_noise(springs);
  continuum.method = continuum_of_lattices();
  continuum.elements.element = *find_element("q1-sri");
  continuum.elements.lattice = springs.method.lattice.value();
  continuum.elements.lattice_direction = fem_reference::LatticeDirection::d100;
  return continuum;
}

SplitPlan plan_split(const CaseSettings& springs, const Method& law) {
  if (!is_law(law.name))
    throw InputError("--split", "reference", "a law of finite elements",
                     "'" + std::string(law.name) + "'");
  if (!springs.method.lattice)
    throw InputError(
        "--split", "method",
        "springs whose continuum fem-cauchy-born is, of " + names_of(lattices()),
        "'" + std::string(springs.method.name) + "'");
  if (springs.body.shape != BodyShape::block)
    throw InputError("--split", "body", "a block, which regular grids can refine",
                     std::string(name_of(springs.body.shape)));
  if (springs.method.lattice->of_cubes && !is_grid_of_cubes(springs.body))
    throw InputError("--split", "cells", "cubes, whose lattice the continuum is of",
                     fmt::format("{} over {} m", fmt::join(springs.body.block.cells, "x"),
                                 fmt::join(springs.body.block.size, "x")));
  if (!has_load(springs))
    throw InputError("--split", "load-fractions", "a load at the end of the path",
                     "none");
  CaseSettings lattice = continuum_of(springs);
  lattice.body = on_hexahedra(springs.body, springs.body.block.cells);
  CaseSettings reference = without_noise(springs);
  reference.body = lattice.body;
  reference.method = law;
  reference.elements.element = lattice.elements.element;
  return {.springs = springs,
          .cauchy_born = convergence_grids(lattice),
          .cauchy_born_check = check_grids(lattice),
          .reference = convergence_grids(reference),
          .reference_check = check_grids(reference)};
}

std::vector<Request> split_requests(const SplitPlan& plan) {
  std::vector<Request> all;
  for (const ThreeCases* cases : {&plan.cauchy_born, &plan.cauchy_born_check,
                                  &plan.reference, &plan.reference_check})
    for (const CaseSettings& settings : *cases) all.push_back({.settings = settings});
  return all;
}

bool SplitQuantity::is_resolved() const {
  return springs && cauchy_born.is_resolved && reference.is_resolved;
}

std::optional<SplitMeasure> answer_to_load(Test test) {
  const std::string answer(entry_of(test).answer);
  if (answer.empty()) return std::nullopt;
  return SplitMeasure{answer,
                      [answer](const Measures& m) { return measure_of(m, answer); }};
}

Split split_error(const SplitPlan& plan, const CaseResult& springs,
                  std::span<const CaseResult> runs, MeshStore& meshes) {
  assert(runs.size() == 12);
  const ContinuumRuns cauchy_born{runs.subspan(0, 3), runs.subspan(3, 3)};
  const ContinuumRuns reference{runs.subspan(6, 3), runs.subspan(9, 3)};
  Split split{.plan = plan};
  // Signed: of the errors' absolute values, parts would not add up where laws disagree
  // on the sign.
  split.quantities.push_back(split_measure({"volume_change", &Measures::volume_change}, 1,
                                           springs, cauchy_born, reference));
  if (const auto answer = answer_to_load(plan.springs.test))
    split.quantities.push_back(
        split_measure(*answer, std::nullopt, springs, cauchy_born, reference));
  split.quantities.push_back(split_field(springs, cauchy_born, reference, meshes));
  for (const CaseResult& run : runs)
    if (run.status != Status::ok)
      split.reasons.push_back(
          fmt::format("{} on {} cells: {}", label(run.request.settings),
                      fmt::join(run.request.settings.body.block.cells, " x "),
                      run.reason.empty() ? name_of(run.status) : run.reason));
  return split;
}

}  // namespace springcheck
