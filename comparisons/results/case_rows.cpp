#include "comparisons/results/case_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>

#include "comparisons/settings/case_json.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::string joined(const std::vector<Status>& flags) {
  const auto name = [](Status flag) { return name_of(flag); };
  return fmt::format("{}", fmt::join(flags | std::views::transform(name), ","));
}

Row::mapped_type cell(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return value.get<std::vector<double>>();
  if (value.is_boolean()) return std::string(value.get<bool>() ? "true" : "false");
  return std::vector{value.get<double>()};
}

std::vector<double> numbers_of(double value) {
  return {value};
}
std::vector<double> numbers_of(const Vector3& value) {
  return {value.data(), value.data() + 3};
}
std::vector<double> numbers_of(const Eigen::Matrix3d& value) {
  const Eigen::Matrix3d columns = value.transpose();  // the file holds rows
  return {columns.data(), columns.data() + 9};
}

/// Puts a value into the row under its name; puts nothing where there is none.
void put_numbers(Row& row, std::string_view name, const auto& value) {
  if (value) row[std::string(name)] = numbers_of(*value);
}

/// A row of a file that is read.
class Reader {
 public:
  Reader(const Columns& cases, std::size_t row, const std::string& file)
      : cases_(cases), row_(row), file_(file) {}

  [[nodiscard]] std::string text(const std::string& name) const {
    const auto column = cases_.texts.find(name);
    return column == cases_.texts.end() ? "" : column->second[row_];
  }

  /// The numbers in the column; null where it is missing, is NaN throughout or has
  /// another width.
  [[nodiscard]] const double* numbers(const std::string& name, std::size_t width) const {
    const auto column = cases_.numbers.find(name);
    if (column == cases_.numbers.end() || column->second.width != width) return nullptr;
    const double* first = column->second.values.data() + row_ * width;
    const bool missing =
        std::all_of(first, first + width, [](double x) { return std::isnan(x); });
    return missing ? nullptr : first;
  }

  [[nodiscard]] double number(const std::string& name) const {
    const double* value = numbers(name, 1);
    if (value == nullptr || !std::isfinite(*value)) refuse(name, "a number", "none");
    return *value;
  }

  [[noreturn]] void refuse(const std::string& what, const std::string& expected,
                           const std::string& got) const {
    throw InputError(file_, fmt::format("{} of case {}", what, text("key")), expected,
                     got);
  }

 private:
  const Columns& cases_;
  std::size_t row_;
  const std::string& file_;
};

void take(const Reader& reader, std::string_view name, Measures::Value& value) {
  if (const double* number = reader.numbers(std::string(name), 1)) value = *number;
}
void take(const Reader& reader, std::string_view name, Measures::Vector& value) {
  if (const double* first = reader.numbers(std::string(name), 3))
    value = Vector3(first[0], first[1], first[2]);
}
void take(const Reader& reader, std::string_view name, Measures::Matrix& value) {
  if (const double* first = reader.numbers(std::string(name), 9))
    value = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(first);
}

std::optional<Effort> effort_of(const Reader& reader) {
  if (reader.text("source") == "measured") return std::nullopt;
  return Effort{
      .load_fraction = reader.number("load_fraction"),
      .steps = static_cast<int>(reader.number("steps")),
      .force_evaluations = static_cast<int>(reader.number("force_evaluations"))};
}

void check_measures(const StoredCase& stored, const Reader& reader) {
  for (const Measure& measure : measure_list)
    if (measure.traits.is_time && stored.effort)
      static_cast<void>(reader.number(std::string(measure.name)));
  if (const auto name = not_finite(stored.measures))
    reader.refuse(*name, "finite numbers", "others");
  // A case of solver limit that ended short of the load has a critical wavelength.
  const bool is_limit = stored.measures.critical_wavelength.has_value();
  const bool is_measured = !is_limit && has_equilibrium(stored.status);
  if (stored.measures.volume_error.has_value() != is_measured)
    reader.refuse("volume_error", is_measured ? "a number" : "none",
                  fmt::format("{} with status {}", is_measured ? "none" : "one",
                              name_of(stored.status)));
}

}  // namespace

Status status_named(const std::string& name, const std::string& file) {
  const auto* found = find_value<Status>(name);
  if (found == nullptr)
    throw InputError(file, "status of a case", "a known status", "'" + name + "'");
  return found->value;
}

Row row_of(const CaseResult& result, const Mesh& mesh, std::size_t provenance) {
  Row row;
  const Solution& solution = result.solution;
  const nlohmann::json settings = settings_json(result.request.settings);
  for (const auto& [name, value] : settings.items())
    if (name != "dt" || value.is_number()) row[name] = cell(value);  // auto: none
  if (result.request.reference) {
    row["reference"] = reference_label(result.request);
    row["reference_settings"] = settings_json(*result.request.reference).dump();
  }
  row["family"] = std::string(name_of(result.request.settings.method.family));
  row["key"] = result.key;
  row["identity"] = case_identity(result.request, mesh);
  row["mesh"] = mesh.sha256();
  row["status"] = std::string(name_of(result.status));
  row["flags"] = joined(result.flags);
  row["reason"] = result.reason;
  for_each_measure(result.measures, [&](const Measure& measure, const auto& value) {
    put_numbers(row, measure.name, value);
  });
  const auto number = [&](const char* name, double value) {
    row[name] = std::vector{value};
  };
  if (result.request.settings.method.solve) {
    number("load_fraction", solution.load_fraction);
    number("steps", solution.steps);
    number("force_evaluations", solution.force_evaluations);
  }
  if (solution.linear_iterations)
    number("linear_iterations", *solution.linear_iterations);
  if (solution.factorisations) number("factorisations", *solution.factorisations);
  put_numbers(row, "dt_used", solution.dt);
  put_numbers(row, "dt_limit", solution.dt_limit);
  number("provenance", static_cast<double>(provenance));
  return row;
}

StoredCase stored_case(const Columns& cases, std::size_t row, const std::string& file) {
  const Reader reader(cases, row, file);
  StoredCase stored{.key = reader.text("key"),
                    .status = status_named(reader.text("status"), file),
                    .reason = reader.text("reason"),
                    .effort = effort_of(reader)};
  std::string flags = reader.text("flags");
  while (!flags.empty()) {
    const std::size_t comma = std::min(flags.find(','), flags.size());
    stored.flags.push_back(status_named(flags.substr(0, comma), file));
    flags.erase(0, comma + 1);
  }
  for_each_measure(stored.measures, [&](const Measure& measure, auto& value) {
    take(reader, measure.name, value);
  });
  if (const double* iterations = reader.numbers("linear_iterations", 1))
    stored.linear_iterations = static_cast<int>(*iterations);
  if (const double* factorisations = reader.numbers("factorisations", 1))
    stored.factorisations = static_cast<int>(*factorisations);
  take(reader, "dt_used", stored.dt);
  take(reader, "dt_limit", stored.dt_limit);
  check_measures(stored, reader);
  return stored;
}

CaseResult with_stored(const Request& request, const StoredCase& stored) {
  const Effort effort = stored.effort.value_or(Effort{});
  return {.request = request,
          .key = stored.key,
          .status = stored.status,
          .flags = stored.flags,
          .reason = stored.reason,
          .measures = stored.measures,
          .solution = {.status = SolveStatus::ok,
                       .lever_arms = LeverArms::deformed,
                       .strain_energy = 0,
                       .load_fraction = effort.load_fraction,
                       .steps = effort.steps,
                       .force_evaluations = effort.force_evaluations,
                       .linear_iterations = stored.linear_iterations,
                       .factorisations = stored.factorisations,
                       .dt = stored.dt,
                       .dt_limit = stored.dt_limit},
          .revision = stored.revision};
}

}  // namespace springcheck
