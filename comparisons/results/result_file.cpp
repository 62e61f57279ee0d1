#include "comparisons/results/result_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <ranges>
#include <system_error>

#include "comparisons/results/provenance.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/results/stored_map.hpp"
#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/results/xdmf.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

/// V/V0 of every cell.
std::vector<double> volume_ratios(const Mesh& mesh, const Solution& solution) {
  std::vector<double> ratios = deformed_volumes(mesh, solution);
  for (std::size_t c = 0; c < ratios.size(); ++c) ratios[c] /= mesh.cell_volumes()[c];
  return ratios;
}

void write_frames(hid_t group, const HistoryFrames& frames, const Mesh& mesh) {
  if (frames.empty()) return;
  const JoinedFrames joined = joined_frames(frames);
  std::vector<double> ratios;
  for (const HistoryFrame& frame : frames) {
    Solution there{};
    there.displacements = frame.displacements;
    const std::vector<double> own = volume_ratios(mesh, there);
    ratios.insert(ratios.end(), own.begin(), own.end());
  }
  hdf5::write_table(group, "frame_sample", joined.samples, 1);
  hdf5::write_table(group, "frame_displacement", joined.displacements);
  hdf5::write_table(group, "frame_cell_volume_ratio", ratios, 1);
}

void write_fields(hid_t fields, const CaseResult& result, const Mesh& mesh) {
  const Solution& solution = result.solution;
  const auto group = hdf5::create_group(fields, result.key);
  if (solution.displacements.empty()) return;  // asked for, and there are none
  const std::string partial = result.measures.volume_error ? "" : "partial_";
  hdf5::write_table(group, partial + "displacement", solution.displacements);
  if (!solution.reactions.empty())
    hdf5::write_table(group, partial + "reaction", solution.reactions);
  hdf5::write_table(group, partial + "cell_volume_ratio", volume_ratios(mesh, solution),
                    1);
  if (!result.history.empty()) {
    std::vector<double> rows;
    for (const HistorySample& sample : result.history)
      rows.insert(rows.end(), sample.begin(), sample.end());
    hdf5::write_table(group, "history", rows, history_columns.size());
    hdf5::write_attribute(group, "history_columns",
                          fmt::format("{}", fmt::join(history_columns, " ")));
    write_frames(group, result.frames, mesh);
  }
  if (!solution.spring_strains.empty())
    hdf5::write_table(group, partial + "spring_strain", solution.spring_strains, 1);
  if (!result.deviation.empty()) hdf5::write_table(group, "deviation", result.deviation);
}

std::filesystem::path xdmf_beside(std::filesystem::path file) {
  return file.replace_extension(".xdmf");
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

bool holds(const StoredKeys& stored, const std::string& key, bool with_fields) {
  const auto known = stored.statuses.find(key);
  return known != stored.statuses.end() &&
         (!with_fields || known->second == Status::refused ||
          stored.with_fields.contains(key));
}

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

void ResultFile::change(const std::function<void(hid_t root)>& change) {
  if (!std::filesystem::exists(file_)) create();
  OverlayFile overlay(file_);
  {
    const hdf5::Handle root(overlay.open(), H5Fclose, file_.string());
    change(root);
  }
  write_pages(file_, overlay.writes());
}

void ResultFile::change_from(
    const std::filesystem::path& from,
    const std::function<void(hid_t source, hid_t root)>& change) {
  if (!std::filesystem::exists(file_)) create();
  std::optional<OverlayFile> overlay;
  reading(from, [&](hid_t source) {
    overlay.emplace(file_);
    const hdf5::Handle root(overlay->open(), H5Fclose, file_.string());
    change(source, root);
    return 0;
  });
  write_pages(file_, overlay->writes());
}

void ResultFile::put(std::span<const CaseResult> results, bool with_fields,
                     MeshStore& meshes) {
  auto answers = results | std::views::filter([](const CaseResult& result) {
                   return result.status != Status::error;
                 });
  if (answers.empty()) return;
  std::map<std::string, std::size_t> new_rows;
  std::map<std::string, std::size_t> sessions = sessions_;
  change([&](hid_t root) {
    const auto session_group = hdf5::open_group(root, "provenance");
    const auto cases = hdf5::open_group(root, "cases"),
               fields = hdf5::open_group(root, "fields"),
               mesh_group = hdf5::open_group(root, "meshes");
    std::vector<Row> added;
    for (const CaseResult& result : answers) {
      const Mesh& mesh = meshes.mesh(result.request.settings.body);
      if (!hdf5::has_link(mesh_group, mesh.sha256())) write_stored_mesh(mesh_group, mesh);
      const auto [session, is_new] =
          sessions.try_emplace(result.revision, row_count(session_group));
      if (is_new) append_rows(session_group, {{provenance(result.revision)}});
      const Row row = row_of(result, mesh, session->second);
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
  sessions_ = std::move(sessions);
  stored_.rows.merge(new_rows);
  for (const CaseResult& result : answers) {
    stored_.statuses[result.key] = result.status;
    if (with_fields)
      stored_.with_fields.insert(result.key);
    else
      stored_.with_fields.erase(result.key);
  }
}

void ResultFile::put_chart(const StoredChart& chart) {
  change([&](hid_t root) { write_chart(hdf5::group_made_in(root, "charts"), chart); });
}

void ResultFile::put_map(const StoredMap& map) {
  change([&](hid_t root) { write_map(hdf5::group_made_in(root, "maps"), map); });
}

void write_xdmf_for(const std::filesystem::path& file, const std::filesystem::path& xdmf,
                    Revisions revisions) {
  const std::filesystem::path from = std::filesystem::absolute(xdmf).parent_path();
  const std::string data = std::filesystem::relative(file, from).string();
  reading(file, [&](hid_t root) {
    write_xdmf(xdmf, data, root, taken_revisions(root, revisions));
    return 0;
  });
}

void write_xdmf_beside(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;  // nothing was to be stored
  reading(file, [&](hid_t root) {
    write_xdmf(xdmf_beside(file), file.filename().string(), root, all_revisions(root));
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

}  // namespace springcheck
