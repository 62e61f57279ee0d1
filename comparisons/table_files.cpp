#include "comparisons/table_files.hpp"

#include <array>
#include <set>

#include "comparisons/table_format.hpp"
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

}  // namespace

void write_tables(const std::filesystem::path& folder, const TableSet& set) {
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
  for (const auto* names : {&table_names(), &sheet_names()})
    all.insert(all.end(), names->begin(), names->end());
  for (const std::string& name : all)
    if (!written.contains(name))
      for (const auto& [extension, format] : file_formats)
        std::filesystem::remove(folder / (name + extension));
}

}  // namespace springcheck
