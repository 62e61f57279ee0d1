#include "comparisons/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>

#include "comparisons/provenance.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/xdmf.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

constexpr long long layout = 2;

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

void write_fields(hid_t fields, const CaseResult& result, const Mesh& mesh) {
  const Solution& solution = result.solution;
  if (solution.displacements.empty()) return;
  const auto group = hdf5::create_group(fields, result.key);
  const std::string partial = result.measures.volume_error ? "" : "partial_";
  hdf5::write_table(group, partial + "displacement", flat(solution.displacements), 3);
  if (!solution.reactions.empty())
    hdf5::write_table(group, partial + "reaction", flat(solution.reactions), 3);
  std::vector<double> ratios = deformed_volumes(mesh, solution);
  for (std::size_t c = 0; c < ratios.size(); ++c) ratios[c] /= mesh.cell_volumes()[c];
  hdf5::write_table(group, partial + "cell_volume_ratio", ratios, 1);
}

std::filesystem::path xdmf_beside(std::filesystem::path file) {
  return file.replace_extension(".xdmf");
}

/// The first column but times and provenance in which two rows of a key differ.
std::optional<std::string> differing_figure(Row a, Row b) {
  for (const char* free : {"wall_s", "solve_wall_s", "provenance"}) {
    a.erase(free);
    b.erase(free);
  }
  for (const Row* row : {&a, &b})
    for (const auto& [name, value] : *row)
      if (!a.contains(name) || !b.contains(name) || a.at(name) != b.at(name)) return name;
  return std::nullopt;
}

/// Waits for a living writer to finish its journal; a dead one's is finished here.
void settle(const std::filesystem::path& file) {
  using namespace std::chrono_literals;
  for (auto waited = 0ms; std::filesystem::exists(journal_of(file)); waited += 10ms) {
    try {
      const LockFile lock(file);
      recover(file);
      return;
    } catch (const InputError&) {
      if (waited > 10s) throw;  // its writer hangs, or the folder cannot be written
    }
    std::this_thread::sleep_for(10ms);
  }
}

/// read(root) of a result file; whatever is wrong with the file is an InputError.
template <class Read>
auto read_once(const std::filesystem::path& file, Read&& read) {
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
  } catch (const std::exception& error) {
    throw InputError(file.string(), "", "a readable springcheck result file",
                     error.what());
  }
}

/// When a file was changed, and its size.
auto state_of(const std::filesystem::path& file) {
  return std::pair(std::filesystem::last_write_time(file),
                   std::filesystem::file_size(file));
}

/// read_once of a file that nobody changes meanwhile: what was seen in between is not
/// believed. `read` may be called again.
template <class Read>
auto reading(const std::filesystem::path& name, Read&& read) {
  constexpr int attempts = 100;
  const std::filesystem::path file = link_target(name);
  if (!std::filesystem::exists(file))
    throw InputError(name.string(), "", "a result file", "no such file");
  for (int attempt = 1;; ++attempt) {
    settle(file);
    const auto before = state_of(file);
    const auto is_same = [&] {
      return state_of(file) == before && !std::filesystem::exists(journal_of(file));
    };
    try {
      auto found = read_once(file, read);
      if (is_same() || attempt == attempts) return found;
    } catch (const InputError&) {
      if (is_same() || attempt == attempts) throw;
    }
  }
}

/// The columns of cases, with what all files of ours have.
Columns cases_in(hid_t root) {
  Columns cases = read_columns(hdf5::open_group(root, "cases"));
  if (cases.rows == 0) return cases;
  for (const char* name : {"key", "status", "mesh"})
    if (!cases.texts.contains(name))
      throw std::runtime_error(fmt::format("the cases have no column '{}'", name));
  const std::size_t sessions = row_count(hdf5::open_group(root, "provenance"));
  const auto provenance = cases.numbers.find("provenance");
  if (provenance == cases.numbers.end() || provenance->second.width != 1)
    throw std::runtime_error("the cases have no column 'provenance'");
  for (const double row : provenance->second.values)
    if (!(row >= 0 && row < static_cast<double>(sessions)))
      throw std::runtime_error(
          fmt::format("column 'provenance' refers to row {} of {}", row, sessions));
  std::set<std::string_view> keys;
  for (const std::string& key : cases.texts.at("key"))
    if (!keys.insert(key).second)
      throw std::runtime_error("case " + key + " is there twice");
  return cases;
}

StoredKeys keys_in(hid_t root, const std::filesystem::path& file) {
  StoredKeys stored;
  const auto cases = hdf5::open_group(root, "cases");
  const auto keys = read_texts(cases, "key"), statuses = read_texts(cases, "status");
  if (keys.size() != row_count(cases) || statuses.size() != keys.size())
    throw std::runtime_error("columns 'key' and 'status' do not belong together");
  for (std::size_t row = 0; row < keys.size(); ++row)
    stored.statuses[keys[row]] = status_named(statuses[row], file.string());
  if (stored.statuses.size() != keys.size())
    throw std::runtime_error("a case is there twice");
  for (std::string& key : hdf5::links(hdf5::open_group(root, "fields")))
    stored.with_fields.insert(std::move(key));
  for (std::string& commit : read_texts(hdf5::open_group(root, "provenance"), "commit"))
    stored.commits.insert(std::move(commit));
  return stored;
}

/// The path, unless that of the .xdmf beside a result file.
std::filesystem::path checked(const std::filesystem::path& file) {
  if (file.extension() == ".xdmf")
    throw InputError(file.string(), "extension", "that of an HDF5 file, such as .h5",
                     ".xdmf, which is written beside it");
  check_writable(file);
  return link_target(file);
}

}  // namespace

ResultFile::ResultFile(const std::filesystem::path& file)
    : file_(checked(file)), lock_(file_) {
  if (!std::filesystem::exists(file_)) return;
  recover(file_);
  stored_ = read_once(file_, [&](hid_t root) { return keys_in(root, file_); });
  const auto keys = read_once(file_, [](hid_t root) {
    return read_texts(hdf5::open_group(root, "cases"), "key");
  });
  for (std::size_t row = 0; row < keys.size(); ++row) rows_[keys[row]] = row;
}

StoredKeys stored_keys(const std::filesystem::path& file) {
  return reading(file, [&](hid_t root) { return keys_in(root, file); });
}

void ResultFile::create() {
  write_whole(file_, [](const std::filesystem::path& unfinished) {
    std::ofstream(unfinished).flush();
    OverlayFile overlay(unfinished);
    {
      const hdf5::Handle root(overlay.create(), H5Fclose, unfinished.string());
      hdf5::write_attribute(root, "layout", layout);
      for (const char* group : {"cases", "provenance", "meshes", "fields"})
        hdf5::create_group(root, group);
    }
    write_pages(unfinished, overlay.writes());
  });
}

/// One commit: what `change` does to the open file, wholly or not at all.
template <class Change>
void ResultFile::change(Change&& change) {
  if (!std::filesystem::exists(file_)) create();
  OverlayFile overlay(file_);
  {
    const hdf5::Handle root(overlay.open(), H5Fclose, file_.string());
    change(root);
  }
  write_pages(file_, overlay.writes());
}

void ResultFile::put(std::span<const CaseResult> results, bool with_fields,
                     MeshStore& meshes) {
  if (results.empty()) return;
  std::map<std::string, std::size_t> new_rows;
  std::size_t provenance_row = 0;
  change([&](hid_t root) {
    const auto sessions = hdf5::open_group(root, "provenance");
    provenance_row = provenance_.value_or(row_count(sessions));
    if (!provenance_) append_rows(sessions, {{provenance()}});

    const auto cases = hdf5::open_group(root, "cases"),
               fields = hdf5::open_group(root, "fields"),
               mesh_group = hdf5::open_group(root, "meshes");
    std::vector<Row> added;
    for (const CaseResult& result : results) {
      const Mesh& mesh = meshes.mesh(result.request.settings.block);
      if (!hdf5::has_link(mesh_group, mesh.sha256())) write_mesh_group(mesh_group, mesh);
      const Row row = row_of(result, mesh, provenance_row);
      if (const auto known = rows_.find(result.key); known != rows_.end())
        replace_row(cases, known->second, row);
      else if (new_rows.try_emplace(result.key, rows_.size() + added.size()).second)
        added.push_back(row);
      else
        continue;  // twice among the results
      hdf5::remove_link(fields, result.key);
      if (with_fields) write_fields(fields, result, mesh);
    }
    append_rows(cases, added);
  });
  provenance_ = provenance_row;
  rows_.merge(new_rows);
  for (const CaseResult& result : results) {
    stored_.statuses[result.key] = result.status;
    if (with_fields && !result.solution.displacements.empty())
      stored_.with_fields.insert(result.key);
    else
      stored_.with_fields.erase(result.key);
  }
}

ResultFile::Absorbed ResultFile::absorb(const std::filesystem::path& from) {
  constexpr std::size_t at_once = 500;  // bounds what a commit keeps in memory
  if (std::error_code none; std::filesystem::equivalent(from, file_, none))
    return {.added = 0, .already_there = rows_.size(), .conflicts = {}};
  const Columns theirs = read_cases(from);
  const Columns ours = std::filesystem::exists(file_) ? read_cases(file_) : Columns{};
  Absorbed absorbed;
  std::vector<std::size_t> lacking;
  std::vector<std::string> without_fields;  // here, of cases that both have
  for (std::size_t i = 0; i < theirs.rows; ++i) {
    const std::string& key = theirs.texts.at("key")[i];
    const auto known = rows_.find(key);
    if (known == rows_.end()) {
      lacking.push_back(i);
      continue;
    }
    ++absorbed.already_there;
    if (const auto column =
            differing_figure(row_at(ours, known->second), row_at(theirs, i)))
      absorbed.conflicts.push_back(
          fmt::format("case {}: {} differs in {}", key, *column, from.string()));
    else if (!stored_.with_fields.contains(key))
      without_fields.push_back(key);
  }
  read_once(from, [&](hid_t source) {
    const auto their_meshes = hdf5::open_group(source, "meshes"),
               their_fields = hdf5::open_group(source, "fields");
    const Columns sessions = read_columns(hdf5::open_group(source, "provenance"));
    std::erase_if(without_fields, [&](const std::string& key) {
      return !hdf5::has_link(their_fields, key);
    });
    if (!without_fields.empty())
      change([&](hid_t root) {
        const auto fields = hdf5::open_group(root, "fields");
        for (const std::string& key : without_fields)
          hdf5::copy_link(their_fields, fields, key);
      });
    stored_.with_fields.insert(without_fields.begin(), without_fields.end());
    std::map<double, double> session_of;  // theirs to ours
    for (std::size_t first = 0; first < lacking.size(); first += at_once) {
      const std::span<const std::size_t> part =
          std::span(lacking).subspan(first, std::min(at_once, lacking.size() - first));
      std::vector<Row> added;
      change([&](hid_t root) {
        const auto meshes = hdf5::open_group(root, "meshes"),
                   fields = hdf5::open_group(root, "fields"),
                   provenance = hdf5::open_group(root, "provenance");
        for (const std::size_t i : part) {
          Row row = row_at(theirs, i);
          const auto& key = std::get<std::string>(row.at("key"));
          const auto& mesh = std::get<std::string>(row.at("mesh"));
          double& session = std::get<std::vector<double>>(row.at("provenance")).front();
          const auto [place, is_new] =
              session_of.try_emplace(session, static_cast<double>(row_count(provenance)));
          if (is_new)
            append_rows(provenance,
                        {{row_at(sessions, static_cast<std::size_t>(session))}});
          session = place->second;
          if (!hdf5::has_link(meshes, mesh)) hdf5::copy_link(their_meshes, meshes, mesh);
          if (hdf5::has_link(their_fields, key)) {
            hdf5::copy_link(their_fields, fields, key);
            stored_.with_fields.insert(key);
          }
          added.push_back(std::move(row));
        }
        append_rows(hdf5::open_group(root, "cases"), added);
      });
      for (const Row& row : added) {
        const auto& key = std::get<std::string>(row.at("key"));
        rows_.emplace(key, rows_.size());
        stored_.statuses.emplace(
            key, status_named(std::get<std::string>(row.at("status")), from.string()));
      }
      absorbed.added += added.size();
    }
    return 0;
  });
  return absorbed;
}

void write_xdmf_beside(const std::filesystem::path& file) {
  reading(file, [&](hid_t root) {
    write_xdmf(xdmf_beside(file), file.filename().string(), root);
    return 0;
  });
}

void write_results(const std::filesystem::path& file, std::span<const CaseResult> results,
                   MeshStore& meshes) {
  ResultFile(file).put(results, true, meshes);
  write_xdmf_beside(file);
}

void check_xdmf_writable(const std::filesystem::path& file) {
  check_writable(xdmf_beside(file));
}

void check_results_writable(const std::filesystem::path& file) {
  const ResultFile opened(file);
  check_xdmf_writable(file);
}

Columns read_cases(const std::filesystem::path& file) {
  return reading(file, [](hid_t root) { return cases_in(root); });
}

std::map<std::string, StoredCase> read_results(const std::filesystem::path& file) {
  return reading(file, [&](hid_t root) {
    const Columns cases = cases_in(root);
    const auto commits = read_texts(hdf5::open_group(root, "provenance"), "commit");
    std::map<std::string, StoredCase> all;
    for (std::size_t row = 0; row < cases.rows; ++row) {
      StoredCase stored = stored_case(cases, row, file.string());
      const auto session =
          static_cast<std::size_t>(cases.numbers.at("provenance").values.at(row));
      stored.commit = commits.at(session);
      all.emplace(cases.texts.at("key").at(row), std::move(stored));
    }
    return all;
  });
}

void read_fields(const std::filesystem::path& file, const Mesh& mesh,
                 CaseResult& result) {
  reading(file, [&](hid_t root) {
    const auto fields = hdf5::open_group(root, "fields");
    if (!hdf5::has_link(fields, result.key)) return 0;
    const auto group = hdf5::open_group(fields, result.key);
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
