#include "comparisons/tables/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {
std::string summary(std::span<const Table> tables,
                    const std::map<std::string, Status>& statuses, double seconds) {
  std::map<Status, int> count;
  for (const auto& [key, status] : statuses) ++count[status];
  std::string text = fmt::format(
      "# springcheck {}: the thesis's comparison tables, regenerated\n\n"
      "Commit {}. {} cases; this run took {:.0f} s before the page.\n\n"
      "Printed figures: K. Golec, \"Hybrid 3D Mass Spring System for Soft Tissue "
      "Simulation\", PhD thesis, 2018, section 5.6. Ours: static equilibria of the same "
      "scenes. Every row of a table names its case in results.h5. "
      "index.html shows these and further sweeps.\n\n"
      "| status | cases |\n| --- | --- |\n",
      build_info::version, build_info::commit, statuses.size(), seconds);
  for (const auto& [status, cases] : count)
    text += fmt::format("| {} | {} |\n", name_of(status), cases);
  const auto found = [&](const CatalogueEntry& entry) {
    return std::ranges::find(tables, entry.name, &Table::name);
  };
  text += "\n## Against the printed figures\n\n";
  for (const CatalogueEntry& entry : catalogue())
    if (const auto table = found(entry);
        is_of_printed_figures(entry) && table != tables.end())
      text += fmt::format("- [{}](tables/{}.md): {}\n", table->title, table->name,
                          table->finding);
  text += "\n## Tables of our own figures\n\n";
  std::string left_out;
  for (const CatalogueEntry& entry : catalogue()) {
    if (is_of_printed_figures(entry)) continue;
    if (const auto table = found(entry); table != tables.end())
      text += fmt::format("- [{}](tables/{}.md)\n", table->title, table->name);
    else
      left_out += fmt::format(
          "- {0} is left out{1}: `springcheck table {0}`, or `springcheck reproduce "
          "--all`\n",
          entry.name, takes_long(entry) ? " and takes many minutes" : "");
  }
  text += left_out +
          "\n## Cases that are not ok\n\n| table | case | status | why |\n"
          "| --- | --- | --- | --- |\n";
  for (const Table& table : tables)
    for (const auto& [name, status, reason] : table.bad_cases)
      text += fmt::format("| {} | {} | {} | {} |\n", table.name, name, status, reason);
  return text;
}

}  // namespace springcheck
