#include "comparisons/commands/table_files.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "comparisons/chart/chart_sheets.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "comparisons/tables/thesis/format_table.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

struct FileFormat {
  const char* extension;
  TableFormat format;
};
constexpr std::array<FileFormat, 4> file_formats{{{".md", TableFormat::markdown},
                                                  {".csv", TableFormat::csv},
                                                  {".json", TableFormat::json},
                                                  {".tex", TableFormat::latex}}};

void take_or_remove(const std::filesystem::path& file,
                    const std::filesystem::path& earlier) {
  if (!std::filesystem::exists(earlier))
    std::filesystem::remove(file);
  else if (!std::filesystem::exists(file) || !std::filesystem::equivalent(file, earlier))
    std::filesystem::copy_file(earlier, file,
                               std::filesystem::copy_options::overwrite_existing);
}

}  // namespace

void write_tables(const std::filesystem::path& folder, const TableSet& set,
                  const std::filesystem::path& earlier) {
  std::set<std::string> written;
  const auto write = [&](const std::string& name, auto&& text_as) {
    for (const auto& [extension, format] : file_formats)
      write_whole_stream(folder / (name + extension),
                         [&](std::ostream& out) { out << text_as(format); });
    written.insert(name);
  };
  for (const Table& table : set.tables)
    write(table.plan.name,
          [&](TableFormat format) { return format_table(table, format); });
  for (const Sheet& sheet : set.sheets)
    write(sheet.name, [&](TableFormat format) { return format_sheet(sheet, format); });
  std::vector<std::string> all{"cases"};
  for (const auto* names : {&table_names(), &sheet_names(), &chart_sheet_names()})
    all.insert(all.end(), names->begin(), names->end());
  for (const std::string& name : all) {
    if (written.contains(name)) continue;
    const bool is_caseless = std::ranges::count(caseless_sheet_names(), name) > 0;
    for (const auto& [extension, format] : file_formats) {
      const std::filesystem::path file = folder / (name + extension);
      if (is_caseless)
        take_or_remove(file, earlier / (name + extension));
      else
        std::filesystem::remove(file);
    }
  }
}

}  // namespace springcheck
