#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "comparisons/names/named.hpp"
#include "comparisons/settings/reference_method.hpp"
#include "comparisons/tables/plans/table_plan.hpp"
#include "comparisons/tables/thesis/comparison.hpp"

namespace springcheck {

/// The source of a table's figures.
enum class Source {
  cases,         // simulations, which a result file keeps and gives back
  when_printed,  // computed or measured while it is printed: no result file has it
  counting       // nothing, in a second: stands beside the thesis's tables
};

template <>
inline constexpr std::array value_names<Source>{
    Named{Source::cases, "cases", "simulations, which result files keep"},
    Named{Source::when_printed, "when printed",
          "computed or measured while it is printed"},
    Named{Source::counting, "counting", "counted, without any simulation"}};

/// A table that `springcheck table` prints, declared once: what computes it, how it is
/// told of, and where the page shows it.
struct CatalogueEntry {
  using OfPrintedFigures = ComparisonPlan (*)(const std::optional<ReferenceMethod>&);
  using OfOurs = TablePlan (*)();

  std::string_view name, title, description;
  std::variant<OfPrintedFigures, OfOurs> plan;
  std::string_view section;  // of the page, by its anchor
  double minutes;            // about, on two cores, where no case is there yet
  Source source = Source::cases;
};

/// All tables, those of the thesis's printed figures first.
std::span<const CatalogueEntry> catalogue();

/// The table of that name. Throws InputError where there is none.
const CatalogueEntry& table_named(std::string_view name);

/// Whether a table stands beside figures that the thesis printed.
bool is_of_printed_figures(const CatalogueEntry& entry);

/// Whether a table takes so long that `reproduce` leaves it out unless asked for all.
bool takes_long(const CatalogueEntry& entry);

/// The plan of an entry, whose table has its name and title. `reference` replaces the
/// default of requests(). Throws InputError for one beside our own tables, which have
/// theirs.
TablePlan plan_of(const CatalogueEntry& entry,
                  const std::optional<ReferenceMethod>& reference = std::nullopt);

/// The catalogue as a table: names, minutes, sources, titles, sections of the page.
Table table_of_tables();

}  // namespace springcheck
