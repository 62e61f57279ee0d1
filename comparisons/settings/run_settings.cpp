#include "comparisons/settings/run_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "comparisons/cases/grids.hpp"
#include "comparisons/settings/body_settings.hpp"
#include "comparisons/settings/setting_values.hpp"
#include "meshing/input_error.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

/// Settings that belong to some tests only.
void check_applicable(const Settings& settings, Test test) {
  const auto refuse = [&](const char* key, const std::string& why) {
    if (const auto found = settings.find(std::string_view(key)); found != settings.end())
      throw InputError(found->second.place(), "", why, "a value");
  };
  if (test == Test::bending)
    refuse("deformation", "no deformation in bending, where gravity acts");
  if (test == Test::traction)
    refuse("deformation", "no deformation in traction, where a traction acts");
  if (test == Test::affine)
    refuse("deformation", "no deformation in affine, where a gradient is imposed");
  if (test != Test::bending) refuse("gravity", "no gravity but in bending");
  if (test != Test::traction) {
    refuse("traction", "no traction but in traction");
    refuse("plates", "no plates but in traction: other tests say how theirs hold");
  }
  if (test != Test::affine) refuse("gradient", "no gradient but in affine");
  if (settings.contains(std::string_view("dt")))
    refuse("dt-ratio", "no dt-ratio beside a dt, which it would replace");
}

/// Whether a method of this name runs, if only as the reference.
bool runs(const RunSettings& run, std::string_view name) {
  return std::ranges::count(run.methods, name, &Method::name) > 0 ||
         (run.reference && run.reference->method.name == name);
}

/// Settings of some methods where nothing runs any of them.
void check_method_runs(const RunSettings& run, const Settings& settings,
                       const std::vector<std::string_view>& methods,
                       std::initializer_list<std::string_view> keys) {
  if (std::ranges::any_of(methods, [&](auto method) { return runs(run, method); }))
    return;
  for (const std::string_view key : keys)
    if (const auto found = settings.find(key); found != settings.end())
      found->second.refuse(fmt::format("no {} without {} as method or reference", key,
                                       fmt::join(methods, " or ")));
}

/// Settings of motion where no method goes through time. A scene file made for dynamics
/// may be solved statically: its own settings are refused only where they ask for output.
void check_motion(const RunSettings& run, const Settings& settings) {
  const auto moves = [&](const Method& method) {
    CaseSettings with = run.common;
    with.method = method;
    return has_history(with);
  };
  if (std::ranges::any_of(run.methods, moves)) return;
  for (const std::string key :
       {"history", "dt", "dt-ratio", "force-dt", "duration", "rate", "load-times",
        "load-fractions", "angular-frequency", "cycles", "damping", "precision"}) {
    const auto found = settings.find(key);
    if (found == settings.end()) continue;
    if (key == "history" || found->second.place() == "--" + key)
      found->second.refuse(
          fmt::format("no {} without a solver that goes through time", key));
  }
}

/// The one that is given of settings that replace each other; nullptr without. Options
/// replace what the scene has. Throws InputError where two stand in the same place.
const Given* one_of(const Settings& settings,
                    std::initializer_list<std::string_view> keys) {
  const Given* chosen = nullptr;
  const auto is_option = [](const Given& given) {
    return given.place().starts_with("--");
  };
  for (const std::string_view key : keys) {
    const auto found = settings.find(key);
    if (found == settings.end()) continue;
    const Given& given = found->second;
    if (chosen != nullptr && is_option(*chosen) == is_option(given))
      given.refuse("no value beside that of " + chosen->place() +
                   ", which it would replace");
    if (chosen == nullptr || is_option(given)) chosen = &given;
  }
  return chosen;
}

const Given* find(const Settings& settings, std::string_view key) {
  const auto found = settings.find(key);
  return found == settings.end() ? nullptr : &found->second;
}

/// A setting that another one needs beside it.
void check_beside(const Settings& settings, const std::string& key,
                  const std::string& other) {
  if (const Given* given = find(settings, key);
      given != nullptr && find(settings, other) == nullptr)
    given->refuse("no " + key + " without " + other);
}

/// Where the load is negative: what is drawn apart comes together. `given` is named.
void check_reversed(const CaseSettings& common, const Given& given) {
  if (common.dynamics.load.empty()) return;
  const double least =
      std::ranges::min_element(common.dynamics.load, {}, &dynamics::LoadPoint::fraction)
          ->fraction;
  if (least >= 0) return;
  const bool pulls = common.test == Test::tension || common.test == Test::uniaxial;
  if (pulls && 1 + least * *common.deformation <= 0)
    given.refuse("no load that presses the plates through each other");
  if (common.test == Test::affine && turns_inside_out(least * common.gradient))
    given.refuse("no load that turns the body inside out");
}

/// Without its load, see read_load.
Dynamics dynamics_of(const Settings& settings) {
  return {.duration = 0,
          .time_step = value_or(settings, "dt", std::optional<double>{}, time_step_of),
          .step_ratio = value_or(settings, "dt-ratio", 0.9, &Given::positive_number),
          .force_time_step = value_or(settings, "force-dt", false, &Given::truth),
          .damping_ratio = value_or(settings, "damping", 0.05, not_negative_of),
          .precision = value_or(settings, "precision", mss::Precision::double_precision,
                                precision_of),
          .history = value_or(settings, "history", 0, sample_count_of)};
}

/// The time over which the load acts, and how: given as a duration, by a rate of the
/// deformation, by points or as an oscillation.
void read_load(CaseSettings& common, const Settings& settings) {
  constexpr double usual = 10;  // [s]
  const Given* given =
      one_of(settings, {"duration", "rate", "load-times", "angular-frequency"});
  Dynamics& dynamics = common.dynamics;
  dynamics.duration = usual;
  check_beside(settings, "load-fractions", "load-times");
  check_beside(settings, "cycles", "angular-frequency");
  if (given == nullptr) return;
  if (given == find(settings, "duration")) {
    dynamics.duration = given->positive_number();
  } else if (given == find(settings, "rate")) {
    const double rate = given->positive_number();
    const double deformation = common.test == Test::affine
                                   ? common.gradient.cwiseAbs().maxCoeff()
                                   : std::abs(common.deformation.value_or(0));
    if (deformation == 0) given->refuse("no rate in a test without a deformation");
    dynamics.duration = deformation / rate;
  } else if (given == find(settings, "angular-frequency")) {
    constexpr double usual_cycles = 5;
    dynamics.oscillation = {
        .angular_frequency = given->positive_number(),
        .cycles = value_or(settings, "cycles", usual_cycles, cycles_of)};
    dynamics.load = dynamics::oscillation(dynamics.oscillation->angular_frequency,
                                          dynamics.oscillation->cycles);
    dynamics.duration = dynamics.load.back().time;
  } else {
    const Given* fractions = find(settings, "load-fractions");
    if (fractions == nullptr) given->refuse("load-fractions beside load-times");
    dynamics.load = load_path_of(*given, *fractions);
    dynamics.duration = dynamics.load.back().time;
  }
  check_reversed(common, *given);
}

/// The law of tissue, and how its time is cut; where the load swings each 64th of a cycle
/// is a piece of it.
Tissue tissue_of(const Settings& settings, const std::string& file, bool oscillates) {
  const Given* given = one_of(settings, {"organ", "law"});
  if (given == nullptr)
    throw InputError(file, "law", "K,n,GAMMA_LIM,p of tissue, or an organ", "nothing");
  const int steps = oscillates ? 1 : 50;
  return {.law = given == find(settings, "organ") ? organ_of(*given) : law_of(*given),
          .branches =
              value_or(settings, "branches", tissue::default_branches, branch_count_of),
          .steps = value_or(settings, "time-steps", steps, time_steps_of)};
}

/// "N" or "NX,NY,NZ" behind a reference's '@'.
std::vector<int> reference_cells_of(const Given& given, const std::string& text) {
  const std::string expected =
      "METHOD[:ELEMENT] and behind it @NX,NY,NZ, @N or @converged, counts of at least 1";
  std::vector<int> cells;
  std::istringstream counts(text);
  for (std::string count; std::getline(counts, count, ',');) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc{} || end != count.data() + count.size() || value < 1)
      given.refuse(expected);
    cells.push_back(value);
  }
  if ((cells.size() != 1 && cells.size() != 3) || text.back() == ',')
    given.refuse(expected);
  return cells;
}

/// The grid of hexahedra that a reference runs on beside a case.
Body grid_beside(const ReferenceMethod& reference, const Body& body) {
  if (body.shape != BodyShape::block)
    throw InputError(reference.place, "grid of the reference",
                     fmt::format("a block, which regular grids can cut; the mesh of a {} "
                                 "is its reference's too",
                                 name_of(body.shape)),
                     "'" + reference.text + "'");
  const Cells& cells = body.block.cells;
  if (reference.cells.empty()) return on_hexahedra(body, cells);
  const auto refuse = [&](const std::string& expected) {
    throw InputError(reference.place, "cells of the reference",
                     fmt::format("{} the case's {}", expected, fmt::join(cells, ",")),
                     fmt::format("{}", fmt::join(reference.cells, ",")));
  };
  if (reference.cells.size() == 1) {
    const int along_x = reference.cells.front();
    if (along_x % cells[0] != 0) refuse("a whole multiple of the first of");
    return on_hexahedra(body, refined(cells, along_x / cells[0]));
  }
  const Cells finer{reference.cells[0], reference.cells[1], reference.cells[2]};
  if (!is_refinement(finer, cells)) refuse("whole multiples of");
  return on_hexahedra(body, finer);
}

}  // namespace

ReferenceMethod reference_named(const Given& given) {
  const std::string text = given.joined();
  const std::size_t at = text.find('@');
  const std::string what = text.substr(0, at);
  const std::size_t colon = what.find(':');
  ReferenceMethod reference{.method = method_named(given, what.substr(0, colon)),
                            .element = *find_element("q1-sri"),
                            .place = given.place(),
                            .text = text};
  if (colon != std::string::npos) {
    if (!is_finite_element(reference.method))
      given.refuse("an element for fem- methods only, and none for fem-explicit-");
    reference.element = element_named(given, what.substr(colon + 1));
  }
  if (at == std::string::npos) return reference;
  if (is_custom(reference.method))
    given.refuse(
        "mss-custom on the case's own mesh: its constants belong to those cells");
  const std::string grid = text.substr(at + 1);
  if (grid == "converged")
    reference.grid = ReferenceGrid::converged;
  else
    reference.cells = reference_cells_of(given, grid);
  return reference;
}

RunSettings make_run_settings(const std::string& name, const std::string& file,
                              const std::vector<GivenSetting>& given) {
  Settings settings;
  for (const auto& [key, value] : given) settings.insert_or_assign(key, value);
  const auto need = [&](const char* key, const char* expected) -> const Given& {
    return required(settings, key, file, expected);
  };
  const Test test = test_of(need("test", "the name of a test"));
  check_applicable(settings, test);
  const std::vector<Method> methods = methods_of(need("method", "a list of methods"));
  const bool all_are_tissue = std::ranges::all_of(methods, is_tissue);

  CaseSettings common{
      .scene = name,
      .test = test,
      .body = body_of(settings, file, test),
      .material = {.young_modulus =
                       all_are_tissue  // which does not read it
                           ? value_or(settings, "young", 1., &Given::positive_number)
                           : need("young", "Young's modulus [Pa]").positive_number(),
                   .poisson_ratio = poisson_ratio_of(need("nu", "a number in (-1, 0.5)")),
                   .density = need("density", "a density [kg/m^3]").positive_number()},
      .gravity = Vector3::Zero(),
      .traction = Vector3::Zero(),
      .plates = value_or(settings, "plates", PlateContact::glued, plates_of),
      .gradient = Eigen::Matrix3d::Zero(),
      .deformation = std::nullopt,
      .method = {},
      .stiffness_form = value_or(settings, "stiffness-form",
                                 mss::StiffnessForm::shear_modulus, stiffness_form_of),
      .diagonal_ratio = value_or(settings, "diagonal-ratio", 1., not_negative_of),
      .element = value_or(settings, "element", *find_element("q1-sri"), element_of),
      .linear_solver = value_or(settings, "linear-solver",
                                fem_reference::LinearSolver::automatic, linear_solver_of),
      .lattice = value_or(settings, "lattice", *find_lattice("mss-cf"), lattice_of),
      .lattice_direction =
          value_or(settings, "lattice-direction", fem_reference::LatticeDirection::d100,
                   lattice_direction_of),
      .constants = std::nullopt,
      .correction =
          value_or(settings, "correction", mss::VolumeCorrection::on, correction_of),
      .solver = value_or(settings, "solver", std::optional<Solver>{}, solver_named),
      .dynamics = dynamics_of(settings),
      .seed = value_or(settings, "seed", 1U, seed_of),
      .noise = value_or(settings, "noise", 0., not_negative_of)};
  if (test == Test::bending)
    common.gravity = load_of(need("gravity", "an acceleration [m/s^2]"), "m/s^2");
  else if (test == Test::traction)
    common.traction =
        traction_of(need("traction", "a force per area [Pa]"), common.plates);
  else if (test == Test::affine)
    common.gradient = gradient_of(need("gradient", "nine numbers, row by row"));
  else
    common.deformation = deformation_of(need("deformation", "a strain or angle"), test);
  read_load(common, settings);

  RunSettings run{
      .common = common,
      .cells_place =
          settings.at(common.body.shape == BodyShape::file ? "mesh" : "cells").place(),
      .methods = methods,
      .reference = std::nullopt,
      .expect = value_or(settings, "expect", std::vector{Status::ok}, expect_of)};
  if (const auto reference = settings.find(std::string_view("reference"));
      reference != settings.end())
    run.reference = reference_named(reference->second);
  check_motion(run, settings);
  check_method_runs(run, settings, {"fem-cauchy-born"}, {"lattice", "lattice-direction"});
  check_method_runs(run, settings, {"mss-custom"}, {"stiffness", "kappa"});
  check_method_runs(run, settings, {"mss-vangelder", "mss-lloyd"}, {"correction"});
  const std::vector<std::string_view> of_branches{"mss-tissue", "fem-tissue"};
  std::vector<std::string_view> of_tissue = of_branches;
  of_tissue.insert(of_tissue.end(), {"mss-thesis-tissue", "mss-thesis-tissue-relative"});
  check_method_runs(run, settings, of_branches, {"branches"});
  check_method_runs(run, settings, of_tissue, {"organ", "law", "time-steps"});
  if (std::ranges::any_of(of_tissue, [&](auto method) { return runs(run, method); }))
    run.common.tissue =
        tissue_of(settings, file, run.common.dynamics.oscillation.has_value());
  if (runs(run, "mss-custom"))
    run.common.constants = mss::LatticeConstants{
        .stiffness = stiffness_of(need("stiffness", "KE,KF,KC of mss-custom [N/m]")),
        .volume_modulus = value_or(settings, "kappa", 0., &Given::finite_number)};
  return run;
}

std::vector<Request> requests(const RunSettings& run) {
  constexpr double small_deformation = 0.02;
  const bool is_small = std::abs(run.common.deformation.value_or(1)) <= small_deformation;
  const ReferenceMethod reference = run.reference.value_or(ReferenceMethod{
      *find_method(is_small ? "fem-hooke" : "fem-stvk"), *find_element("q1-sri")});
  std::vector<Request> all;
  for (const Method& method : run.methods) {
    Request request{.settings = run.common, .reference = run.common};
    request.settings.method = method;
    request.reference->method = reference.method;
    request.reference->element = reference.element;
    if (reference.grid == ReferenceGrid::converged || !reference.cells.empty())
      request.reference->body = grid_beside(reference, run.common.body);
    request.reference_grid = reference.grid;
    const bool is_limit = solver_of(request.settings) == Solver::path_limit;
    if (is_limit || (is_tissue(method) && !run.reference)) {
      // A limit is no state at the load, and no other law is tissue's.
      request.reference.reset();
      request.reference_grid = ReferenceGrid::one;
      all.push_back(request);
      continue;
    }
    if (reference.grid == ReferenceGrid::one &&
        settings_json(request.settings) == settings_json(*request.reference))
      request.reference.reset();
    all.push_back(request);
  }
  return all;
}

}  // namespace springcheck
