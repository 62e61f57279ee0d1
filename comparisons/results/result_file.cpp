#include "comparisons/results/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "comparisons/results/provenance.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/results/stored_map.hpp"
#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/results/xdmf.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

std::vector<double> flat(const std::vector<Vector3>& vectors) {
  std::vector<double> values;
  for (const Vector3& v : vectors) values.insert(values.end(), v.begin(), v.end());
  return values;
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
  if (!result.history.empty()) {
    std::vector<double> rows;
    for (const HistorySample& sample : result.history)
      rows.insert(rows.end(), sample.begin(), sample.end());
    hdf5::write_table(group, "history", rows, history_columns.size());
  }
  if (!solution.spring_strains.empty())
    hdf5::write_table(group, partial + "spring_strain", solution.spring_strains, 1);
  if (!result.deviation.empty())
    hdf5::write_table(group, "deviation", flat(result.deviation), 3);
}

/// A group, made where the file has none.
hdf5::Handle group_of(hid_t root, const char* name) {
  return hdf5::has_link(root, name) ? hdf5::open_group(root, name)
                                    : hdf5::create_group(root, name);
}

/// Copies the maps that a file lacks, or has without their limits.
void copy_maps(hid_t from, hid_t to) {
  for (const std::string& name : hdf5::links(from)) {
    const auto has_limits = [&](hid_t maps) {
      const auto map = hdf5::open_group(maps, name);
      return row_count(hdf5::open_group(map, "limits")) > 0;
    };
    if (hdf5::has_link(to, name)) {
      if (has_limits(to) || !has_limits(from)) continue;
      hdf5::remove_link(to, name);
    }
    hdf5::copy_link(from, to, name);
  }
}

std::filesystem::path xdmf_beside(std::filesystem::path file) {
  return file.replace_extension(".xdmf");
}

/// The first column in which two rows of a key differ, but for times, provenance, and the
/// family, which follows from the method and which files of before 0.3.0 lack.
std::optional<std::string> differing_figure(Row a, Row b) {
  for (const char* free : {"wall_s", "solve_wall_s", "provenance", "family"}) {
    a.erase(free);
    b.erase(free);
  }
  for (const Row* row : {&a, &b})
    for (const auto& [name, value] : *row)
      if (!a.contains(name) || !b.contains(name) || a.at(name) != b.at(name)) return name;
  return std::nullopt;
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
}

void ResultFile::create() {
  write_whole(file_, [](const std::filesystem::path& unfinished) {
    std::ofstream(unfinished).flush();
    OverlayFile overlay(unfinished);
    {
      const hdf5::Handle root(overlay.create(), H5Fclose, unfinished.string());
      hdf5::write_attribute(root, "layout", result_layout);
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
      const Mesh& mesh = meshes.mesh(result.request.settings.body);
      if (!hdf5::has_link(mesh_group, mesh.sha256())) write_stored_mesh(mesh_group, mesh);
      const Row row = row_of(result, mesh, provenance_row);
      if (const auto known = stored_.rows.find(result.key); known != stored_.rows.end())
        replace_row(cases, known->second, row);
      else if (new_rows.try_emplace(result.key, stored_.rows.size() + added.size())
                   .second)
        added.push_back(row);
      else
        continue;  // twice among the results
      hdf5::remove_link(fields, result.key);
      if (with_fields) write_fields(fields, result, mesh);
    }
    append_rows(cases, added);
  });
  provenance_ = provenance_row;
  stored_.rows.merge(new_rows);
  for (const CaseResult& result : results) {
    stored_.statuses[result.key] = result.status;
    if (with_fields && !result.solution.displacements.empty())
      stored_.with_fields.insert(result.key);
    else
      stored_.with_fields.erase(result.key);
  }
}

void ResultFile::put_chart(const StoredChart& chart) {
  change([&](hid_t root) { write_chart(group_of(root, "charts"), chart); });
}

void ResultFile::put_map(const StoredMap& map, MapState state) {
  change([&](hid_t root) { write_map(group_of(root, "maps"), map, state); });
}

ResultFile::Absorbed ResultFile::absorb(const std::filesystem::path& from,
                                        const std::set<std::string>* keys) {
  constexpr std::size_t at_once = 500;  // bounds what a commit keeps in memory
  if (std::error_code none; std::filesystem::equivalent(from, file_, none))
    return {.added = 0, .already_there = stored_.rows.size()};
  const Columns theirs = read_cases(from);
  const Columns ours = std::filesystem::exists(file_) ? read_cases(file_) : Columns{};
  Absorbed absorbed;
  std::vector<std::size_t> lacking;
  std::vector<std::string> without_fields;  // here, of cases that both have
  for (std::size_t i = 0; i < theirs.rows; ++i) {
    const std::string& key = theirs.texts.at("key")[i];
    if (keys != nullptr && !keys->contains(key)) continue;
    const auto known = stored_.rows.find(key);
    if (known == stored_.rows.end()) {
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
        stored_.rows.emplace(key, stored_.rows.size());
        stored_.statuses.emplace(
            key, status_named(std::get<std::string>(row.at("status")), from.string()));
      }
      absorbed.added += added.size();
    }
    if (keys == nullptr && hdf5::has_link(source, "maps"))
      change([&](hid_t root) {
        copy_maps(hdf5::open_group(source, "maps"), group_of(root, "maps"));
      });
    if (keys == nullptr && hdf5::has_link(source, "charts"))
      change([&](hid_t root) {
        merge_charts(hdf5::open_group(source, "charts"), group_of(root, "charts"));
      });
    return 0;
  });
  return absorbed;
}

void write_xdmf_for(const std::filesystem::path& file,
                    const std::filesystem::path& xdmf) {
  const std::filesystem::path from = std::filesystem::absolute(xdmf).parent_path();
  const std::string data = std::filesystem::relative(file, from).string();
  reading(file, [&](hid_t root) {
    write_xdmf(xdmf, data, root);
    return 0;
  });
}

void write_xdmf_beside(const std::filesystem::path& file) {
  write_xdmf_for(file, xdmf_beside(file));
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

}  // namespace springcheck
