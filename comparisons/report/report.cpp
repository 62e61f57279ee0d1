#include "comparisons/report/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "comparisons/chart/chart_json.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/report/report_program.hpp"
#include "comparisons/report/table_files.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/stability/atlas_json.hpp"
#include "comparisons/tables/stored_tables.hpp"
#include "comparisons/tables/theory_curves.hpp"
#include "comparisons/vocabulary/vocabulary.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {

namespace {

/// Refuses a folder whose page somebody else made: it would be lost.
void check_page_is_ours(const std::filesystem::path& folder) {
  const std::filesystem::path page = folder / "index.html";
  std::ifstream in(page);
  if (!in) return;
  std::string head(1000, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.find("content=\"springcheck report\"") == std::string::npos)
    throw InputError(page.string(), "", "the page of an earlier report, or none",
                     "another page, which would be lost");
}

}  // namespace

void prepare_report(const std::filesystem::path& folder) {
  check_python();
  check_page_is_ours(folder);
  for (const char* part : {"tables", "data"}) {
    std::error_code failed;
    std::filesystem::create_directories(folder / part, failed);
    if (failed)
      throw InputError(folder.string(), "", "a folder that can be created",
                       failed.message());
  }
  for (const char* file : {"tables/5.1.md", "data/theory.json", "index.html"})
    check_writable(folder / file);
}

/// What the page is made from beside tables: a line of JSON in data/NAME.json.
static void write_data(const std::filesystem::path& folder, const std::string& name,
                       const std::string& json) {
  write_whole_stream(folder / "data" / (name + ".json"),
                     [&](std::ostream& out) { out << json << "\n"; });
}

ExitStatus make_report(const std::filesystem::path& file,
                       const std::filesystem::path& folder,
                       const std::vector<Table>& further, Revisions revisions) {
  const FolderLock lock(folder);
  MeshStore meshes;
  std::vector<Table> tables = stored_tables(file, meshes, revisions);
  tables.insert(tables.end(), further.begin(), further.end());
  const std::vector<Chart> charts = stored_charts(file, revisions);
  for (Table& table : chart_tables(charts)) tables.push_back(std::move(table));
  const OtherRevisions taken = other_revisions(stored_cases({file}, revisions));
  write_tables(folder / "tables", tables, file.parent_path() / "tables");
  const std::string note = !taken.empty()
                               ? note_of_taken(taken)
                               : note_of_other_revisions(stored_keys(file), revisions);
  write_data(folder, "theory", theory_curves(read_cases(file, revisions)).dump());
  write_data(folder, "vocabulary", list_json().dump());
  write_data(folder, "revisions", nlohmann::json{{"note", note}}.dump());
  write_data(folder, "charts", charts_json(charts).dump());
  write_data(folder, "atlas", atlas_json(file, revisions).dump());
  if (run_report_program(file, folder) != 0) return ExitStatus::fell_short;
  const std::filesystem::path xdmf = folder / "3d" / "cases.xdmf";
  if (std::filesystem::exists(folder / "3d" / "show.py"))  // made where there are fields
    write_xdmf_for(file, xdmf, revisions);
  else
    std::filesystem::remove(xdmf);
  fmt::print("Start with {}\n", (folder / "index.html").string());
  return ExitStatus::done;
}

}  // namespace springcheck
