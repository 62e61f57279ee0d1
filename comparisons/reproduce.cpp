#include "comparisons/reproduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <system_error>

#include "comparisons/build_info.hpp"
#include "comparisons/known_results.hpp"
#include "comparisons/memory.hpp"
#include "comparisons/progress.hpp"
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

/// The row of a method that is furthest from its printed value, relative to it or, for
/// printed percentages, in points. Empty when none has a printed value.
std::string worst_against_thesis(const Table& table, const std::string& method) {
  const bool points = table.plan.quantity.unit == "%";
  const TableRow* worst = nullptr;
  double largest = -1;
  int compared = 0;
  for (const TableRow& row : table.rows) {
    if (row.result.request.settings.method.name != method || !row.difference) continue;
    ++compared;
    const double size = points ? std::abs(*row.difference)
                               : std::abs(*row.difference / *row.plan.printed);
    if (size > largest) {
      largest = size;
      worst = &row;
    }
  }
  if (worst == nullptr) return {};
  return fmt::format(
      "{} {} rows; furthest from print: {} ({}){}", compared, method,
      row_name(table, *worst),
      points ? fmt::format("{:+.2f} points", *worst->difference)
             : fmt::format("{:+.1f} %", 100 * *worst->difference / *worst->plan.printed),
      worst->plan.notes.empty() ? "" : ": see its notes in the table");
}

/// mss-cf against the thesis's own, and the law that reproduces its FEM column.
std::string against_thesis(const Table& table) {
  std::string text = worst_against_thesis(table, "mss-cf");
  if (text.empty()) return "no printed figure of mss-cf to compare with";
  const std::string fem = worst_against_thesis(table, "fem-hencky");
  return fem.empty() ? text : text + "; " + fem;
}

std::string summary(const ComputedTables& computed, double seconds) {
  const auto& [tables, sheets, results] = computed;
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
                        against_thesis(table));
  text += "\n## Tables of our own figures\n\n";
  for (const Sheet& sheet : sheets)
    text += fmt::format("- [{}](tables/{}.md)\n", sheet.title, sheet.name);
  for (const std::string& name : long_sheet_names())
    if (std::ranges::count(sheets, name, &Sheet::name) == 0)
      text += fmt::format(
          "- {0} takes many minutes and is left out: `springcheck table {0}`, or "
          "`springcheck reproduce --all`\n",
          name);
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

/// Known results, but none without its fields where they are needed.
KnownResult with_fields_if(bool needed, const KnownResult& known) {
  if (!needed || !known) return known;
  return [known](const Request& request, const std::string& key) {
    auto result = known(request, key);
    if (result && result->measures.volume_error && result->solution.displacements.empty())
      result.reset();
    return result;
  };
}

std::vector<CaseResult> results_of(
    const std::vector<Request>& requests, MeshStore& meshes, int parallel,
    const KnownResult& known, const std::function<void(const CaseResult&)>& computed) {
  Progress progress("simulations");
  std::vector<CaseResult> results(requests.size());
  std::set<std::string> known_keys;
  const KnownResult noted = [&](const Request& request, const std::string& key) {
    auto result = known ? known(request, key) : std::nullopt;
    if (result) known_keys.insert(key);
    return result;
  };
  run_study(
      requests, meshes, parallel,
      [&](std::size_t done, std::size_t of) { progress.show(done, of); }, noted,
      [&](std::size_t request, CaseResult&& result) {
        if (computed && !known_keys.contains(result.key)) computed(result);
        results[request] = std::move(result);
      });
  return results;
}

void append(std::vector<Request>& all, const std::vector<Request>& further) {
  all.insert(all.end(), further.begin(), further.end());
}

}  // namespace

ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel, const KnownResult& known,
                              const std::function<void(const CaseResult&)>& computed) {
  std::vector<TablePlan> plans;
  std::vector<SheetPlan> sheets;
  std::vector<Request> all, of_sheets;
  for (const std::string& name : names)
    if (std::ranges::count(sheet_names(), name) > 0) {
      if (reference)
        throw InputError(reference->place, "", "no reference: table " + name + " has its",
                         "one");
      sheets.push_back(plan_sheet(name));
      append(of_sheets, sheets.back().requests);
    } else {
      plans.push_back(plan_table(name, reference));
      append(all, table_requests(plans.back()));
    }
  append(all, of_sheets);
  check_memory("table", all);
  ComputedTables answer{
      .tables = {},
      .sheets = {},
      .results = results_of(all, meshes, parallel, with_fields_if(!sheets.empty(), known),
                            computed)};
  auto next = answer.results.begin();
  for (TablePlan& plan : plans) {
    const auto count = static_cast<std::ptrdiff_t>(table_requests(plan).size());
    answer.tables.push_back(fill_table(std::move(plan), {next, next + count}));
    next += count;
  }
  for (const SheetPlan& plan : sheets) {
    const std::size_t count = plan.requests.size();
    answer.sheets.push_back(plan.make({next, count}, meshes));
    next += static_cast<std::ptrdiff_t>(count);
  }
  return answer;
}

void reproduce(const std::filesystem::path& directory, Extent extent, int parallel) {
  const auto start = std::chrono::steady_clock::now();
  std::error_code failed;
  std::filesystem::create_directories(directory / "tables", failed);
  if (failed)
    throw InputError(directory.string(), "", "a folder that can be created",
                     failed.message());
  const std::filesystem::path result_file = directory / "results.h5";
  check_results_writable(result_file);
  check_writable(directory / "tables" / "5.1.md");

  std::vector<std::string> names = table_names();
  for (const std::string& name : sheet_names())
    if (extent == Extent::all || std::ranges::count(long_sheet_names(), name) == 0)
      names.push_back(name);
  MeshStore meshes;
  ResultFile file(result_file);
  const StoredCases stored = std::filesystem::exists(result_file)
                                 ? of_this_commit(stored_cases({result_file}))
                                 : StoredCases{};
  const auto [tables, sheets, results] =
      compute_tables(names, std::nullopt, meshes, parallel, known_from(stored, meshes),
                     [&](const CaseResult& result) {
                       file.put({&result, 1}, true, meshes);
                     });
  write_xdmf_beside(result_file);
  const auto write_table = [&](const std::string& name, auto&& text_as) {
    const std::filesystem::path stem = directory / "tables" / name;
    write_text(stem.string() + ".md", text_as(TableFormat::markdown));
    write_text(stem.string() + ".csv", text_as(TableFormat::csv));
    write_text(stem.string() + ".json", text_as(TableFormat::json));
  };
  for (const Table& table : tables)
    write_table(table.plan.name,
                [&](TableFormat format) { return format_table(table, format); });
  for (const Sheet& sheet : sheets)
    write_table(sheet.name,
                [&](TableFormat format) { return format_sheet(sheet, format); });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  write_text(directory / "summary.md",
             summary({tables, sheets, results}, elapsed.count()));
}

}  // namespace springcheck
