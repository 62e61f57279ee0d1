#include "comparisons/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "comparisons/build_info.hpp"
#include "comparisons/hdf5.hpp"
#include "comparisons/xdmf.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

constexpr long long layout = 1;

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string utc_now() {
  const std::time_t now =
      std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text.data();
}

void write_provenance(hid_t root) {
  hdf5::write_attribute(root, "layout", layout);
  hdf5::write_attribute(root, "springcheck", std::string(build_info::version));
  hdf5::write_attribute(root, "commit", std::string(build_info::commit));
  hdf5::write_attribute(root, "compiler", std::string(build_info::compiler));
  hdf5::write_attribute(root, "deal.II", std::string(build_info::deal_ii_version));
  hdf5::write_attribute(root, "gmsh", gmsh_version());
  hdf5::write_attribute(root, "Eigen", std::string(build_info::eigen_version));
  hdf5::write_attribute(root, "HDF5", std::string(build_info::hdf5_version));
  hdf5::write_attribute(root, "cpu", cpu_name());
  hdf5::write_attribute(root, "cores",
                        static_cast<long long>(std::thread::hardware_concurrency()));
  hdf5::write_attribute(root, "date", utc_now());
}

std::vector<double> flat(const std::vector<Vector3>& vectors) {
  std::vector<double> values;
  for (const Vector3& v : vectors) values.insert(values.end(), v.begin(), v.end());
  return values;
}

/// The inverse of flat.
std::vector<Vector3> vectors(const std::vector<double>& values) {
  std::vector<Vector3> all;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    all.emplace_back(values[i], values[i + 1], values[i + 2]);
  return all;
}

template <std::size_t N>
std::vector<std::uint32_t> flat(const std::vector<std::array<NodeIndex, N>>& cells) {
  std::vector<std::uint32_t> values;
  for (const auto& cell : cells) values.insert(values.end(), cell.begin(), cell.end());
  return values;
}

void write_mesh_group(hid_t meshes, const Mesh& mesh) {
  const auto group = hdf5::create_group(meshes, mesh.sha256());
  hdf5::write_attribute(group, "source", mesh.source());
  hdf5::write_table(group, "nodes", flat(mesh.nodes()), 3);
  hdf5::write_table(group, "hexahedra", flat(mesh.hexahedra()), 8);
  const auto regions = hdf5::create_group(group, "regions");
  for (const auto& [name, region] : mesh.regions())
    hdf5::write_table(regions, name, flat(region.faces), 4);
}

std::string joined(const std::vector<Status>& flags) {
  std::string text;
  for (const Status flag : flags)
    text += (text.empty() ? "" : ",") + std::string(name_of(flag));
  return text;
}

void write_settings(hid_t group, const nlohmann::json& settings) {
  for (const auto& [name, value] : settings.items())
    if (value.is_string())
      hdf5::write_attribute(group, name, value.get<std::string>());
    else if (value.is_array())
      hdf5::write_attribute(group, name,
                            std::span<const double>(value.get<std::vector<double>>()));
    else if (value.is_boolean())
      hdf5::write_attribute(group, name,
                            std::string(value.get<bool>() ? "true" : "false"));
    else
      hdf5::write_attribute(group, name, value.get<double>());
}

void write_measure(hid_t group, const char* name, const Measures::Value& value) {
  if (value) hdf5::write_attribute(group, name, *value);
}
void write_measure(hid_t group, const char* name, const Measures::Vector& value) {
  if (value)
    hdf5::write_attribute(group, name, std::span<const double>(value->data(), 3));
}
void write_measure(hid_t group, const char* name, const Measures::Matrix& value) {
  if (!value) return;
  const Eigen::Matrix3d columns = value->transpose();  // the file holds rows
  hdf5::write_attribute(group, name, std::span<const double>(columns.data(), 9));
}

void read_measure(hid_t group, const char* name, Measures::Value& value) {
  if (const auto numbers = hdf5::read_numbers(group, name);
      numbers && numbers->size() == 1)
    value = numbers->front();
}
void read_measure(hid_t group, const char* name, Measures::Vector& value) {
  if (const auto numbers = hdf5::read_numbers(group, name);
      numbers && numbers->size() == 3)
    value = Vector3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}
void read_measure(hid_t group, const char* name, Measures::Matrix& value) {
  if (const auto numbers = hdf5::read_numbers(group, name);
      numbers && numbers->size() == 9)
    value =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers->data());
}

void write_case(hid_t cases, const CaseResult& result, const Mesh& mesh) {
  const auto group = hdf5::create_group(cases, result.key);
  const Solution& solution = result.solution;
  write_settings(group, settings_json(result.request.settings));
  if (result.request.reference) {
    hdf5::write_attribute(group, "reference", reference_label(result.request));
    hdf5::write_attribute(group, "reference_settings",
                          settings_json(*result.request.reference).dump());
  }
  hdf5::write_attribute(group, "mesh", mesh.sha256());
  hdf5::write_attribute(group, "status", std::string(name_of(result.status)));
  hdf5::write_attribute(group, "flags", joined(result.flags));
  hdf5::write_attribute(group, "reason", result.reason);
  for_each_measure(result.measures, [&](const char* name, const auto& value) {
    write_measure(group, name, value);
  });
  hdf5::write_attribute(group, "load_fraction", solution.load_fraction);
  hdf5::write_attribute(group, "steps", static_cast<long long>(solution.steps));
  hdf5::write_attribute(group, "force_evaluations",
                        static_cast<long long>(solution.force_evaluations));
  if (solution.linear_iterations)
    hdf5::write_attribute(group, "linear_iterations",
                          static_cast<long long>(*solution.linear_iterations));
  write_measure(group, "dt_used", solution.dt);
  write_measure(group, "dt_limit", solution.dt_limit);
  hdf5::write_attribute(group, "wall_s", result.wall_s);
  hdf5::write_attribute(group, "solve_wall_s", result.solve_wall_s);

  if (solution.displacements.empty()) return;
  const std::string partial = result.measures.volume_error ? "" : "partial_";
  hdf5::write_table(group, partial + "displacement", flat(solution.displacements), 3);
  hdf5::write_table(group, partial + "reaction", flat(solution.reactions), 3);
  std::vector<double> ratios = deformed_volumes(mesh, solution);
  for (std::size_t c = 0; c < ratios.size(); ++c) ratios[c] /= mesh.cell_volumes()[c];
  hdf5::write_table(group, partial + "cell_volume_ratio", ratios, 1);
}

Status status_of(const std::string& name, const std::string& file) {
  const auto found =
      std::ranges::find(all_statuses(), name, [](Status s) { return name_of(s); });
  if (found == all_statuses().end())
    throw InputError(file, "status of a case", "a known status", "'" + name + "'");
  return *found;
}

/// Throws InputError where measures are no numbers, or do not go with the status: a case
/// has a volume if and only if it ended in an equilibrium.
void check_measures(const StoredCase& stored, const std::string& key,
                    const std::string& file) {
  if (const auto name = not_finite(stored.measures))
    throw InputError(file, fmt::format("{} of case {}", *name, key), "finite numbers",
                     "others");
  const bool has_equilibrium =
      stored.status == Status::ok || stored.status == Status::indefinite ||
      stored.status == Status::wrinkled || stored.status == Status::inverted;
  if (stored.measures.volume_error.has_value() != has_equilibrium)
    throw InputError(file, fmt::format("volume_error of case {}", key),
                     has_equilibrium ? "a number" : "none",
                     fmt::format("{} with status {}", has_equilibrium ? "none" : "one",
                                 name_of(stored.status)));
}

StoredCase read_case(hid_t group, const std::string& key, const std::string& file) {
  const auto number = [&](const char* name) {
    const auto values = hdf5::read_numbers(group, name);
    if (!values || values->size() != 1 || !std::isfinite(values->front()))
      throw InputError(file, fmt::format("attribute '{}' of case {}", name, key),
                       "a number", "none");
    return values->front();
  };
  StoredCase stored{
      .status = status_of(hdf5::read_text(group, "status").value_or(""), file),
      .flags = {},
      .reason = hdf5::read_text(group, "reason").value_or(""),
      .measures = {},
      .load_fraction = number("load_fraction"),
      .steps = static_cast<int>(number("steps")),
      .force_evaluations = static_cast<int>(number("force_evaluations")),
      .linear_iterations = {},
      .dt = {},
      .dt_limit = {},
      .wall_s = number("wall_s"),
      .solve_wall_s = number("solve_wall_s")};
  std::string flags = hdf5::read_text(group, "flags").value_or("");
  while (!flags.empty()) {
    const std::size_t comma = std::min(flags.find(','), flags.size());
    stored.flags.push_back(status_of(flags.substr(0, comma), file));
    flags.erase(0, comma + 1);
  }
  for_each_measure(stored.measures, [&](const char* name, auto& value) {
    read_measure(group, name, value);
  });
  if (hdf5::read_numbers(group, "linear_iterations"))
    stored.linear_iterations = static_cast<int>(number("linear_iterations"));
  read_measure(group, "dt_used", stored.dt);
  read_measure(group, "dt_limit", stored.dt_limit);
  check_measures(stored, key, file);
  return stored;
}

std::filesystem::path xdmf_beside(std::filesystem::path file) {
  return file.replace_extension(".xdmf");
}

/// read(root) of a result file; whatever is wrong with the file is an InputError.
template <class Read>
auto reading(const std::filesystem::path& file, Read&& read) {
  if (!std::filesystem::exists(file))
    throw InputError(file.string(), "", "a result file", "no such file");
  try {
    const auto root = hdf5::open_file(file);
    const auto found = hdf5::read_numbers(root, "layout");
    if (!found)
      throw InputError(file.string(), "", "a springcheck result file",
                       "an HDF5 file without a layout number");
    if (found->size() != 1 || found->front() != static_cast<double>(layout))
      throw InputError(file.string(), "layout", std::to_string(layout),
                       fmt::format("{:g}", fmt::join(*found, ", ")));
    return read(root);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(file.string(), "", "a readable springcheck result file",
                     error.what());
  }
}

}  // namespace

void write_results(const std::filesystem::path& file,
                   const std::vector<CaseResult>& results, MeshStore& meshes) {
  const auto root = hdf5::create_in_memory();
  write_provenance(root);
  {
    const auto mesh_group = hdf5::create_group(root, "meshes");
    const auto case_group = hdf5::create_group(root, "cases");
    for (const CaseResult& result : results) {
      const Mesh& mesh = meshes.mesh(result.request.settings.block);
      if (!hdf5::has_link(mesh_group, mesh.sha256())) write_mesh_group(mesh_group, mesh);
      if (!hdf5::has_link(case_group, result.key)) write_case(case_group, result, mesh);
    }
  }
  write_whole_stream(file, [&](std::ostream& out) { out << hdf5::file_image(root); });
  write_xdmf(xdmf_beside(file), file.filename().string(), results, meshes);
}

void check_results_writable(const std::filesystem::path& file) {
  if (file.extension() == ".xdmf")
    throw InputError(file.string(), "extension", "that of an HDF5 file, such as .h5",
                     ".xdmf, which is written beside it");
  check_writable(file);
  check_writable(xdmf_beside(file));
}

std::map<std::string, StoredCase> read_results(const std::filesystem::path& file) {
  return reading(file, [&](hid_t root) {
    std::map<std::string, StoredCase> cases;
    const auto case_group = hdf5::open_group(root, "cases");
    for (const std::string& key : hdf5::links(case_group))
      cases.emplace(key,
                    read_case(hdf5::open_group(case_group, key), key, file.string()));
    return cases;
  });
}

std::string commit_of(const std::filesystem::path& file) {
  return reading(file, [](hid_t root) {
    return hdf5::read_text(root, "commit").value_or("unknown");
  });
}

CaseResult with_stored(const Request& request, const std::string& key,
                       const StoredCase& stored) {
  return {.request = request,
          .key = key,
          .status = stored.status,
          .flags = stored.flags,
          .reason = stored.reason,
          .measures = stored.measures,
          .solution = {.status = SolveStatus::ok,
                       .reason = {},
                       .displacements = {},
                       .reactions = {},
                       .lever_arms = LeverArms::deformed,
                       .strain_energy = 0,
                       .load_fraction = stored.load_fraction,
                       .steps = stored.steps,
                       .force_evaluations = stored.force_evaluations,
                       .linear_iterations = stored.linear_iterations,
                       .dt = stored.dt,
                       .dt_limit = stored.dt_limit},
          .wall_s = stored.wall_s,
          .solve_wall_s = stored.solve_wall_s};
}

void read_fields(const std::filesystem::path& file, const Mesh& mesh,
                 CaseResult& result) {
  reading(file, [&](hid_t root) {
    const auto cases = hdf5::open_group(root, "cases");
    const auto group = hdf5::open_group(cases, result.key);
    const std::string partial = result.measures.volume_error ? "" : "partial_";
    const auto table = [&](const char* name, std::size_t count) {
      auto values = hdf5::read_table(group, partial + name);
      if (values && values->size() != count)
        throw InputError(
            file.string(), fmt::format("{}{} of case {}", partial, name, result.key),
            fmt::format("{} numbers", count), fmt::to_string(values->size()));
      return values;
    };
    const std::size_t nodes = mesh.nodes().size(), cells = mesh.hexahedra().size();
    if (const auto displacements = table("displacement", 3 * nodes))
      result.solution.displacements = vectors(*displacements);
    if (const auto reactions = table("reaction", 3 * nodes))
      result.solution.reactions = vectors(*reactions);
    if (const auto ratios = table("cell_volume_ratio", cells)) {
      result.solution.cell_volumes = *ratios;
      for (std::size_t c = 0; c < cells; ++c)
        result.solution.cell_volumes[c] *= mesh.cell_volumes()[c];
    }
    return 0;
  });
}

}  // namespace springcheck
