#pragma once

// How settings are read and told. This is for setting_table.cpp alone.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <ranges>

#include "comparisons/settings/cut_keys.hpp"
#include "comparisons/settings/reference_method.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/setting_values.hpp"

namespace springcheck::setting_table {

template <class Value>
nlohmann::json json_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return name_of(value);
  else if constexpr (requires { value.name; })
    return value.name;
  else
    return value;
}

inline nlohmann::json json_of(const Vector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

inline nlohmann::json json_of(const Eigen::Matrix3d& matrix) {
  nlohmann::json numbers;  // row by row
  for (const double number : matrix.reshaped<Eigen::RowMajor>())
    numbers.push_back(number);
  return numbers;
}

template <class Value>
nlohmann::json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : nlohmann::json();
}

/// The text of a list of any length, as options have it: a column of a result file holds
/// texts, or lists of one length.
template <auto number>
nlohmann::json load_points(const CaseSettings& c) {
  const auto of_point = [](const dynamics::LoadPoint& point) { return point.*number; };
  return fmt::format("{}",
                     fmt::join(c.dynamics.load | std::views::transform(of_point), ","));
}

template <auto member, auto... members>
auto& part_of(auto& whole) {
  if constexpr (sizeof...(members) == 0)
    return whole.*member;
  else
    return part_of<members...>(whole.*member);
}

/// What a reader returns of what was given; it may need what has been read of the case so
/// far.
template <auto reader>
auto read_with(const Given& given, const CaseSettings& so_far) {
  if constexpr (std::is_invocable_v<decltype(reader), const Given&>)
    return std::invoke(reader, given);
  else
    return std::invoke(reader, given, so_far);
}

template <auto reader>
constexpr ValueType type_read = type_of<decltype(read_with<reader>(
    std::declval<const Given&>(), std::declval<const CaseSettings&>()))>();

template <auto reader, auto... members>
constexpr Access value{.read =
                           [](RunSettings& run, const Given& given) {
                             part_of<members...>(run.common) =
                                 read_with<reader>(given, run.common);
                           },
                       .told = [](const CaseSettings& c) -> nlohmann::json {
                         return json_of(part_of<members...>(c));
                       },
                       .type = type_read<reader>};

/// Access to a value that keys and JSON do not tell.
template <auto reader, auto... members>
constexpr Access untold{.read = value<reader, members...>.read,
                        .type = type_read<reader>};

/// Access to a value of the run, which its cases do not tell.
template <auto reader, auto member>
constexpr Access in_run{
    .read = [](RunSettings& run, const Given& given) { run.*member = reader(given); },
    .type = type_read<reader>};

/// The access to the same value, told otherwise.
template <class Told>
constexpr Access telling(Access access, Told told) {
  access.told = told;
  return access;
}

/// The access to the same value, of which more is understood than its reader's type says.
constexpr Access of_type(Access access, const ValueType& type) {
  access.type = type;
  return access;
}

/// Access to a value whose names are digits.
template <class T>
constexpr Access in_digits(Access access) {
  return of_type(access, {.kind = ValueType::Kind::integer, .names = all_names<T>});
}

constexpr ValueType list_of_tables{
    .kind = ValueType::Kind::table, .least = 1, .most = ValueType::any_number};
constexpr ValueType text = type_of<std::string>(),
                    texts = type_of<std::vector<std::string>>(),
                    number = type_of<double>(), numbers = type_of<std::vector<double>>();
template <std::size_t n>
constexpr ValueType so_many_numbers = type_of<std::array<double, n>>();

template <auto reader, auto member>
constexpr Access in_body = value<reader, &CaseSettings::body, member>;
template <auto reader, auto member>
constexpr Access untold_in_body = untold<reader, &CaseSettings::body, member>;
template <auto reader, auto member>
constexpr Access in_block = value<reader, &CaseSettings::body, &Body::block, member>;
template <auto reader, auto member>
constexpr Access in_material = value<reader, &CaseSettings::material, member>;
template <auto reader, auto member>
constexpr Access in_springs = value<reader, &CaseSettings::springs, member>;
template <auto reader, auto member>
constexpr Access in_elements = value<reader, &CaseSettings::elements, member>;
template <auto reader, auto member>
constexpr Access in_motion = value<reader, &CaseSettings::dynamics, member>;

// Settings that are more than one value in a case:

inline nlohmann::json method_told(const CaseSettings& c) {
  return c.method.name;
}

inline void read_reference(RunSettings& run, const Given& given) {
  run.reference = reference_named(given);
}

inline void read_cuts(RunSettings& run, const Given& given) {
  run.common.body.cuts = cuts_of(given);
}

inline nlohmann::json cuts_told(const CaseSettings& c) {
  return c.body.cuts.empty() ? nlohmann::json() : nlohmann::json(text_of(c.body.cuts));
}

inline nlohmann::json seed_told(const CaseSettings& c) {
  return c.search.seed;
}

inline nlohmann::json stiffness_told(const CaseSettings& c) {
  const mss::LatticeStiffness& k = c.springs.constants.value().stiffness;
  return {k.edge, k.face_diagonal, k.inner_diagonal};
}

inline nlohmann::json kappa_told(const CaseSettings& c) {
  return c.springs.constants.value().volume_modulus;
}

inline nlohmann::json solver_told(const CaseSettings& c) {
  return name_of(solver_of(c));
}

inline nlohmann::json time_step_told(const CaseSettings& c) {
  if (c.dynamics.time_step) return *c.dynamics.time_step;
  return "auto";
}

inline nlohmann::json history_told(const CaseSettings& c) {
  return c.dynamics.history == 0 ? nlohmann::json() : nlohmann::json(c.dynamics.history);
}

inline void read_stiffness(RunSettings& run, const Given& given) {
  const auto [edge, face_diagonal, inner_diagonal] = stiffness_of(given);
  run.common.springs.constants = mss::LatticeConstants{
      .stiffness = {edge, face_diagonal, inner_diagonal}, .volume_modulus = 0};
}

inline void read_kappa(RunSettings& run, const Given& given) {
  if (run.common.springs.constants)
    run.common.springs.constants->volume_modulus = given.finite_number();
}

inline void read_seed(RunSettings& run, const Given& given) {
  run.common.search.seed = seed_of(given);
  if (run.common.body.shape != BodyShape::file && reads_seed(run.common.body.block))
    run.common.body.block.seed = run.common.search.seed;
}

inline void read_mesh(RunSettings& run, const Given& given) {
  run.common.body.shape = BodyShape::file;
  if (given.text().empty()) given.refuse("a path");
  run.common.body.file = given.path();
}

/// Reads the rate, which gives the time in which the deformation is reached.
inline void read_rate(RunSettings& run, const Given& given) {
  const double rate = given.positive_number();
  const CaseSettings& c = run.common;
  const double deformation = c.test == Test::affine ? c.gradient.cwiseAbs().maxCoeff()
                                                    : std::abs(c.deformation.value_or(0));
  if (deformation == 0) given.refuse("no rate in a test without a deformation");
  run.common.dynamics.duration = deformation / rate;
}

inline void set_load(Dynamics& dynamics, dynamics::LoadPath load) {
  dynamics.duration = load.back().time;
  dynamics.load = std::move(load);
}

inline void read_cycles(RunSettings& run, const Given& given) {
  Dynamics& dynamics = run.common.dynamics;
  if (!dynamics.oscillation) return;
  dynamics.oscillation->cycles = cycles_of(given);
  set_load(dynamics, dynamics::oscillation(dynamics.oscillation->angular_frequency,
                                           dynamics.oscillation->cycles));
}

inline void read_organ(RunSettings& run, const Given& given) {
  run.common.tissue.law = named<tissue::Organ>(given).law;
}

inline void read_law(RunSettings& run, const Given& given) {
  const auto [K, n, limit, p] = law_of(given);
  run.common.tissue.law = {
      .consistency = K, .linear_index = n, .linear_limit = limit, .hardening_index = p};
}

inline nlohmann::json law_told(const CaseSettings& c) {
  const tissue::BipowerLaw& law = c.tissue.law;
  return fmt::format("{},{},{},{}", law.consistency, law.linear_index, law.linear_limit,
                     law.hardening_index);
}

/// Reads the number of time steps; where the load swings, each 64th of a cycle is a piece
/// of it.
inline void read_time_steps(RunSettings& run, const Given& given) {
  const bool swings = run.common.dynamics.oscillation.has_value();
  run.common.tissue.steps = time_steps_of(given).value_or(swings ? 1 : 50);
}

inline nlohmann::json time_steps_told(const CaseSettings& c) {
  return c.tissue.steps;
}

inline void read_load_times(RunSettings& run, const Given& given) {
  set_load(run.common.dynamics, load_times_of(given));
}

inline void read_fractions(RunSettings& run, const Given& given) {
  set_fractions(run.common.dynamics.load, given);
}

inline void read_frequency(RunSettings& run, const Given& given) {
  run.common.dynamics.oscillation = {.angular_frequency = given.positive_number(),
                                     .cycles = 0};
}

inline nlohmann::json frequency_told(const CaseSettings& c) {
  return c.dynamics.oscillation->angular_frequency;
}

inline nlohmann::json cycles_told(const CaseSettings& c) {
  return c.dynamics.oscillation->cycles;
}

}  // namespace springcheck::setting_table
