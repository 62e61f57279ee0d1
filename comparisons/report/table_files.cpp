#include "comparisons/report/table_files.hpp"

#include <algorithm>
#include <array>

#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "meshing/basics/output_file.hpp"

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

void write_tables(const std::filesystem::path& folder, std::span<const Table> tables,
                  const std::filesystem::path& earlier) {
  for (const Table& table : tables)
    for (const auto& [extension, format] : file_formats)
      write_whole_stream(folder / (table.name + extension),
                         [&](std::ostream& out) { out << format_table(table, format); });
  const auto clear = [&](const std::string& name, bool comes_from_earlier) {
    if (std::ranges::count(tables, name, &Table::name) > 0) return;
    for (const auto& [extension, format] : file_formats) {
      const std::filesystem::path file = folder / (name + extension);
      if (comes_from_earlier)
        take_or_remove(file, earlier / (name + extension));
      else
        std::filesystem::remove(file);
    }
  };
  clear("cases", false);
  for (const std::string& name : chart_table_names()) clear(name, false);
  for (const CatalogueEntry& entry : catalogue())
    clear(std::string(entry.name), entry.source == Source::when_printed);
}

}  // namespace springcheck
