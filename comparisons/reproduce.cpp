#include "comparisons/reproduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <system_error>

#include "comparisons/build_info.hpp"
#include "comparisons/memory.hpp"
#include "comparisons/progress.hpp"
#include "comparisons/result_file.hpp"
#include "comparisons/table_format.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
  write_whole_stream(file, [&](std::ostream& out) { out << text; });
}

/// "nu 0, deformation 5 %, method mss-cf".
std::string row_name(const Table& table, const TableRow& row) {
  std::string name;
  for (std::size_t i = 0; i < row.plan.labels.size(); ++i)
    name += fmt::format("{}{} {}", i == 0 ? "" : ", ", table.plan.label_headings[i],
                        row.plan.labels[i]);
  return name;
}

/// The row of mss-cf that is furthest from its printed value, relative to it or, for
/// printed percentages, in points.
std::string worst_against_thesis(const Table& table) {
  const bool points = table.plan.quantity.unit == "%";
  const TableRow* worst = nullptr;
  double largest = -1;
  int compared = 0;
  for (const TableRow& row : table.rows) {
    const bool ours_by_thesis = row.result.request.settings.method.name == "mss-cf";
    if (!ours_by_thesis || !row.difference) continue;
    ++compared;
    const double size = points ? std::abs(*row.difference)
                               : std::abs(*row.difference / *row.plan.printed);
    if (size > largest) {
      largest = size;
      worst = &row;
    }
  }
  if (worst == nullptr) return "no printed figure of mss-cf to compare with";
  return fmt::format(
      "{} mss-cf rows; furthest from print: {} ({}){}", compared, row_name(table, *worst),
      points ? fmt::format("{:+.2f} points", *worst->difference)
             : fmt::format("{:+.1f} %", 100 * *worst->difference / *worst->plan.printed),
      worst->plan.notes.empty() ? "" : ": see its notes in the table");
}

std::string summary(const std::vector<Table>& tables,
                    const std::vector<CaseResult>& results, double seconds) {
  std::map<Status, int> count;
  std::set<std::string> keys;
  for (const CaseResult& result : results)
    if (keys.insert(result.key).second) ++count[result.status];
  std::string text = fmt::format(
      "# springcheck {}: the thesis's comparison tables, regenerated\n\n"
      "Commit {}. {} cases in {:.0f} s.\n\n"
      "Printed figures: K. Golec, \"Hybrid 3D Mass Spring System for Soft Tissue "
      "Simulation\", PhD thesis, 2018, section 5.6. Ours: static equilibria of the same "
      "scenes. Every row of a table names its case in results.h5.\n\n"
      "| status | cases |\n| --- | --- |\n",
      build_info::version, build_info::commit, keys.size(), seconds);
  for (const auto& [status, cases] : count)
    text += fmt::format("| {} | {} |\n", name_of(status), cases);
  text += "\n## Against the printed figures\n\n";
  for (const Table& table : tables)
    text += fmt::format("- [{}](tables/{}.md): {}\n", table.plan.title, table.plan.name,
                        worst_against_thesis(table));
  text +=
      "\n## Cases that are not ok\n\n| table | case | status | why |\n"
      "| --- | --- | --- | --- |\n";
  for (const Table& table : tables)
    for (const TableRow& row : table.rows)
      if (row.result.status != Status::ok)
        text +=
            fmt::format("| {} | {} | {} | {} |\n", table.plan.name, row_name(table, row),
                        name_of(row.result.status), row.result.reason);
  return text;
}

}  // namespace

ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel, const KnownResult& known) {
  std::vector<TablePlan> plans;
  std::vector<Request> all;
  for (const std::string& name : names) {
    plans.push_back(plan_table(name, reference));
    const std::vector<Request> needed = table_requests(plans.back());
    all.insert(all.end(), needed.begin(), needed.end());
  }
  check_memory("table", all, parallel);
  Progress progress("simulations");
  ComputedTables computed{
      .tables = {},
      .results = run_study(
          all, meshes, parallel,
          [&](std::size_t done, std::size_t of) { progress.show(done, of); }, known)};
  auto next = computed.results.begin();
  for (TablePlan& plan : plans) {
    const auto count = static_cast<std::ptrdiff_t>(table_requests(plan).size());
    computed.tables.push_back(fill_table(std::move(plan), {next, next + count}));
    next += count;
  }
  return computed;
}

void reproduce(const std::filesystem::path& directory, int parallel) {
  const auto start = std::chrono::steady_clock::now();
  std::error_code failed;
  std::filesystem::create_directories(directory / "tables", failed);
  if (failed)
    throw InputError(directory.string(), "", "a folder that can be created",
                     failed.message());
  const std::filesystem::path result_file = directory / "results.h5";
  check_writable(result_file);
  check_writable(directory / "tables" / "5.1.md");

  MeshStore meshes;
  const auto [tables, results] =
      compute_tables(table_names(), std::nullopt, meshes, parallel);
  write_results(result_file, results, meshes);
  for (const Table& table : tables) {
    const std::filesystem::path stem = directory / "tables" / table.plan.name;
    write_text(stem.string() + ".md", format_table(table, TableFormat::markdown));
    write_text(stem.string() + ".csv", format_table(table, TableFormat::csv));
    write_text(stem.string() + ".json", format_table(table, TableFormat::json));
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  write_text(directory / "summary.md", summary(tables, results, elapsed.count()));
}

}  // namespace springcheck
