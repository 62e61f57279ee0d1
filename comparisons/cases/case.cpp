#include "comparisons/cases/case.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace springcheck {

namespace {

bool reads_lattice(const Method& method) {
  const auto* law = std::get_if<fem_reference::Law>(&method.model);
  return law != nullptr && *law == fem_reference::Law::cauchy_born;
}

nlohmann::json row_by_row(const Eigen::Matrix3d& matrix) {
  nlohmann::json numbers;
  for (const double number : matrix.reshaped<Eigen::RowMajor>())
    numbers.push_back(number);
  return numbers;
}

/// What a mesh is made of; the file of a user's mesh is not, whose content the case's key
/// holds.
void add_body_settings(nlohmann::json& json, const Body& body, Test test) {
  json["body"] = name_of(body.shape);
  if (body.shape == BodyShape::file) {
    if (has_lower_plate(test)) json["fixed"] = body.fixed;
    if (has_upper_plate(test)) json["moved"] = body.moved;
    return;
  }
  const Block& block = body.block;
  json["size"] = block.size;
  json["cells"] = block.cells;
  json["cell-type"] = name_of(block.pattern);
  if (body.shape == BodyShape::block) json["distortion"] = block.distortion;
  if (reads_seed(block)) json["seed"] = block.seed;
}

/// Settings of the finite elements alone.
void add_reference_settings(nlohmann::json& json, const CaseSettings& settings) {
  using fem_reference::Springs;
  json["element"] = settings.element.name;
  json["linear-solver"] = name_of(settings.linear_solver);
  json["solver"] = "static";
  if (!reads_lattice(settings.method)) return;
  const Springs springs = settings.lattice.springs;
  json["lattice"] = settings.lattice.name;
  json["lattice-direction"] = name_of(settings.lattice_direction);
  if (springs != Springs::baudet)
    json["stiffness-form"] = name_of(settings.stiffness_form);
  if (springs == Springs::fd || springs == Springs::cf)
    json["diagonal-ratio"] = settings.diagonal_ratio;
}

/// A list of any length, as options have it: a column of a result file holds texts, or
/// lists of one length.
std::string joined(const dynamics::LoadPath& load, double dynamics::LoadPoint::*number) {
  std::string text;
  for (const dynamics::LoadPoint& point : load)
    text += fmt::format("{}{}", text.empty() ? "" : ",", point.*number);
  return text;
}

/// The load through time, and when it is looked at.
void add_load(nlohmann::json& json, const Dynamics& dynamics) {
  if (const auto& oscillation = dynamics.oscillation) {
    json["angular-frequency"] = oscillation->angular_frequency;
    json["cycles"] = oscillation->cycles;
  }
  json["duration"] = dynamics.duration;
  if (!dynamics.load.empty() && !dynamics.oscillation) {
    json["load-times"] = joined(dynamics.load, &dynamics::LoadPoint::time);
    json["load-fractions"] = joined(dynamics.load, &dynamics::LoadPoint::fraction);
  }
  if (dynamics.history > 0) json["history"] = dynamics.history;
}

void add_time_step(nlohmann::json& json, const Dynamics& dynamics) {
  json["force-dt"] = dynamics.force_time_step;
  if (dynamics.time_step) {
    json["dt"] = *dynamics.time_step;
  } else {
    json["dt"] = "auto";
    json["dt-ratio"] = dynamics.step_ratio;
  }
}

void add_dynamics(nlohmann::json& json, const Dynamics& dynamics) {
  json["damping"] = dynamics.damping_ratio;
  json["precision"] = name_of(dynamics.precision);
  add_load(json, dynamics);
  add_time_step(json, dynamics);
}

/// Settings of the springs alone.
void add_spring_settings(nlohmann::json& json, const CaseSettings& settings) {
  switch (std::get<mss::Method>(settings.method.model)) {
    case mss::Method::custom: {
      const auto& [k, kappa] = settings.constants.value();
      json["stiffness"] = {k.edge, k.face_diagonal, k.inner_diagonal};
      json["kappa"] = kappa;
      break;
    }
    case mss::Method::fd:
    case mss::Method::cf:
      json["diagonal-ratio"] = settings.diagonal_ratio;
      [[fallthrough]];
    case mss::Method::nfd:
      json["stiffness-form"] = name_of(settings.stiffness_form);
      break;
    case mss::Method::vangelder:
    case mss::Method::lloyd:
      json["correction"] = name_of(settings.correction);
      break;
    case mss::Method::affine:
    case mss::Method::baudet:
      break;
  }
  json["solver"] = name_of(solver_of(settings));
  if (goes_through_time(settings)) {
    add_dynamics(json, settings.dynamics);
  } else if (solver_of(settings) == Solver::static_equilibrium) {
    json["seed"] = settings.seed;
    json["noise"] = settings.noise;
  }
}

void add_tissue_settings(nlohmann::json& json, const CaseSettings& settings) {
  const auto& [law, branches, steps] = settings.tissue.value();
  json.erase("young");
  json["law"] = fmt::format("{},{},{},{}", law.consistency, law.linear_index,
                            law.linear_limit, law.hardening_index);
  if (!is_thesis_tissue(settings.method)) json["branches"] = branches;
  json["solver"] = name_of(solver_of(settings));
  add_load(json, settings.dynamics);
  if (goes_through_time(settings))
    add_time_step(json, settings.dynamics);
  else
    json["time-steps"] = steps;
}

void add_explicit_settings(nlohmann::json& json, const CaseSettings& settings) {
  json["solver"] = name_of(solver_of(settings));
  if (goes_through_time(settings)) add_dynamics(json, settings.dynamics);
}

/// What stands for a solver's settings where there was none of ours.
void add_measured_settings(nlohmann::json& json, const Measured& measured) {
  json["source"] = "measured";
  json["displacements"] = measured.displacements;
  if (!measured.forces.empty()) json["forces"] = measured.forces;
}

}  // namespace

bool has_lower_plate(Test test) {
  return test != Test::affine;
}

bool has_upper_plate(Test test) {
  return test != Test::bending && test != Test::affine;
}

const std::vector<Test>& all_tests() {
  static const std::vector<Test> all{Test::compression, Test::tension, Test::shearing,
                                     Test::torsion,     Test::bending, Test::uniaxial,
                                     Test::traction,    Test::affine};
  return all;
}

std::string_view name_of(Test test) {
  switch (test) {
    case Test::compression:
      return "compression";
    case Test::tension:
      return "tension";
    case Test::shearing:
      return "shearing";
    case Test::torsion:
      return "torsion";
    case Test::bending:
      return "bending";
    case Test::uniaxial:
      return "uniaxial";
    case Test::traction:
      return "traction";
    case Test::affine:
      return "affine";
  }
  return {};
}

std::string_view name_of(PlateContact contact) {
  return contact == PlateContact::glued ? "glued" : "sliding";
}

std::string_view name_of(Solver solver) {
  switch (solver) {
    case Solver::static_equilibrium:
      return "static";
    case Solver::path_limit:
      return "limit";
    case Solver::explicit_euler:
      return "explicit";
    case Solver::semi_implicit_euler:
      return "semi-implicit";
    case Solver::verlet:
      return "verlet";
    case Solver::implicit_euler:
      return "implicit";
  }
  return {};
}

std::string_view name_of(mss::Precision precision) {
  return precision == mss::Precision::double_precision ? "double" : "float";
}

Solver solver_of(const CaseSettings& settings) {
  if (is_finite_element(settings.method)) return Solver::static_equilibrium;
  return settings.solver.value_or(is_explicit_element(settings.method)
                                      ? Solver::semi_implicit_euler
                                      : Solver::static_equilibrium);
}

bool goes_through_time(const CaseSettings& settings) {
  const Solver solver = solver_of(settings);
  return solver != Solver::static_equilibrium && solver != Solver::path_limit;
}

bool has_history(const CaseSettings& settings) {
  return goes_through_time(settings) || is_tissue(settings.method);
}

std::string_view name_of(mss::StiffnessForm form) {
  return form == mss::StiffnessForm::shear_modulus ? "mu" : "E";
}

std::string_view name_of(mss::VolumeCorrection correction) {
  return correction == mss::VolumeCorrection::on ? "on" : "off";
}

std::string_view name_of(fem_reference::LatticeDirection direction) {
  switch (direction) {
    case fem_reference::LatticeDirection::d100:
      return "100";
    case fem_reference::LatticeDirection::d110:
      return "110";
    case fem_reference::LatticeDirection::d111:
      return "111";
  }
  return {};
}

std::string_view name_of(fem_reference::LinearSolver solver) {
  switch (solver) {
    case fem_reference::LinearSolver::automatic:
      return "auto";
    case fem_reference::LinearSolver::direct:
      return "direct";
    case fem_reference::LinearSolver::multigrid:
      return "multigrid";
  }
  return {};
}

fem_reference::Settings reference_settings(const CaseSettings& settings) {
  using fem_reference::SpringConstants;
  return {.law = std::get<fem_reference::Law>(settings.method.model),
          .element = settings.element.element,
          .lattice = {.springs = settings.lattice.springs,
                      .diagonal_ratio = settings.diagonal_ratio,
                      .constants =
                          settings.stiffness_form == mss::StiffnessForm::shear_modulus
                              ? SpringConstants::from_shear_modulus
                              : SpringConstants::from_young_modulus,
                      .direction = settings.lattice_direction},
          .linear_solver = settings.linear_solver};
}

nlohmann::json settings_json(const CaseSettings& settings) {
  nlohmann::json json{
      {"scene", settings.scene},
      {"test", name_of(settings.test)},
      {"young", settings.material.young_modulus},
      {"nu", settings.material.poisson_ratio},
      {"density", settings.material.density},
      {"method", settings.method.name},
  };
  add_body_settings(json, settings.body, settings.test);
  if (settings.deformation) json["deformation"] = *settings.deformation;
  if (settings.test == Test::bending)
    json["gravity"] = {settings.gravity.x(), settings.gravity.y(), settings.gravity.z()};
  if (settings.test == Test::traction) {
    json["traction"] = {settings.traction.x(), settings.traction.y(),
                        settings.traction.z()};
    json["plates"] = name_of(settings.plates);
  }
  if (settings.test == Test::affine) json["gradient"] = row_by_row(settings.gradient);
  if (is_finite_element(settings.method))
    add_reference_settings(json, settings);
  else if (is_explicit_element(settings.method))
    add_explicit_settings(json, settings);
  else if (is_tissue(settings.method))
    add_tissue_settings(json, settings);
  else if (const auto* measured = std::get_if<Measured>(&settings.method.model))
    add_measured_settings(json, *measured);
  else
    add_spring_settings(json, settings);
  return json;
}

std::string label(const CaseSettings& settings) {
  if (is_finite_element(settings.method))
    return fmt::format("{}:{}", settings.method.name, settings.element.name);
  return std::string(settings.method.name);
}

}  // namespace springcheck
