#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>

#include "comparisons/formats/table.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/reference_method.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "comparisons/tables/computed_tables.hpp"
#include "comparisons/tables/thesis/comparison.hpp"
#include "comparisons/tables/thesis/printed_figures.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"
#include "tests/comparisons/tables/rectangular.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(thesis_tables_test)

namespace {

ComparisonPlan plan_comparison(const std::string& name,
                               const std::optional<ReferenceMethod>& reference = {}) {
  return std::get<CatalogueEntry::OfPrintedFigures>(table_named(name).plan)(reference);
}

std::vector<std::string> printed_names() {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue())
    if (is_of_printed_figures(entry)) names.emplace_back(entry.name);
  return names;
}

/// Results of a plan's requests without computing: e = .0317, or a limit point.
std::vector<CaseResult> invented(const ComparisonPlan& plan, Status status) {
  std::vector<CaseResult> results;
  for (const Request& request : table_plan(plan).requests) {
    CaseResult result{};
    result.request = request;
    result.key = "0123456789abcdef";
    result.status = status;
    result.solution.load_fraction = status == Status::ok ? 1 : 0.5;
    if (status == Status::ok) result.measures.volume_error = 0.0317;
    results.push_back(result);
  }
  return results;
}

}  // namespace

// Spot checks against the thesis's own pages: first, middle and last printed rows.
BOOST_AUTO_TEST_CASE(printed_figures_are_the_thesis_s) {
  BOOST_TEST(printed_figures("5.1").size() == 24U);
  BOOST_TEST(printed_figures("5.2").size() == 24U);
  BOOST_TEST(printed_figures("5.3").size() == 8U);
  BOOST_TEST(printed_figures("5.4").size() == 8U);
  BOOST_TEST(printed_figures("deviation").size() == 6U);
  const PrintedFigure first = printed_figures("5.1").front();
  BOOST_TEST(first.method == "mss-baudet");
  BOOST_TEST(first.text == "2.6");
  BOOST_TEST(first.verdict == "yes");
  const PrintedFigure last = printed_figures("5.4").back();
  BOOST_TEST(last.value == 57981);
  BOOST_TEST(last.deformation == std::numbers::pi / 4,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(every_printed_figure_has_its_row) {
  for (const char* name : {"5.1", "5.2", "5.3", "5.4", "deviation"}) {
    std::multiset<double> printed, planned;
    for (const PrintedFigure& figure : printed_figures(name))
      printed.insert(figure.value);
    for (const PlannedRow& row : plan_comparison(name, std::nullopt).rows)
      if (row.printed && label(row.request.settings) != "fem-hooke:q1-sri" &&
          label(row.request.settings) != "fem-hencky:q1-sri" &&
          row.request.settings.springs.stiffness_form ==
              mss::StiffnessForm::shear_modulus)
        planned.insert(*row.printed);
    BOOST_TEST((printed == planned), name);
  }
}

BOOST_AUTO_TEST_CASE(
    methods_that_are_not_in_the_thesis_have_a_row_for_each_of_its_loads) {
  using Load = std::pair<double, double>;
  for (const char* name : {"5.1", "5.2", "5.3", "5.4"}) {
    std::set<Load> printed;
    for (const PrintedFigure& figure : printed_figures(name))
      printed.insert({figure.nu, figure.deformation});
    std::map<std::pair<std::string, std::string>, std::multiset<Load>> planned;
    for (const PlannedRow& row : plan_comparison(name, std::nullopt).rows) {
      const CaseSettings& settings = row.request.settings;
      BOOST_TEST(row.printed.has_value() != settings.method.beside_printed);
      if (row.printed) continue;
      BOOST_TEST(row.printed_text.empty());
      BOOST_TEST(row.verdict.empty());
      const std::string_view law = settings.method.same_law_as;
      planned[{settings.method.name,
               law.empty() ? "" : row.request.reference->method.name}]
          .insert({settings.material.poisson_ratio, *settings.deformation});
    }
    std::vector<std::pair<std::string, std::string>> rows;
    for (const auto& [method_and_law, loads] : planned) {
      rows.push_back(method_and_law);
      BOOST_TEST((loads == std::multiset<Load>(printed.begin(), printed.end())),
                 name << " " << method_and_law.first);
    }
    // The rows stand beside their own law and beside the thesis's.
    const std::vector<std::pair<std::string, std::string>> expected{
        {"mss-affine-hencky", "fem-hencky"},
        {"mss-affine-stvk", "fem-hencky"},
        {"mss-affine-stvk", "fem-stvk"},
        {"mss-hencky", "fem-hencky"},
        {"mss-stvk", "fem-hencky"},
        {"mss-stvk", "fem-stvk"},
        {"mss-uniform", ""}};
    BOOST_TEST((rows == expected), name);
  }
}

BOOST_AUTO_TEST_CASE(a_reference_that_was_asked_for_is_that_of_every_row) {
  const ReferenceMethod hooke{*find_method("fem-hooke"), *find_element("q1")};
  std::size_t of_stvk = 0;
  for (const PlannedRow& row : plan_comparison("5.3", hooke).rows) {
    BOOST_TEST(reference_label(row.request) == "fem-hooke:q1");
    if (row.request.settings.method.name == "mss-stvk") ++of_stvk;
  }
  BOOST_TEST(of_stvk == 2U);  // one per load
}

// The note belongs to compression and tension at nu = .499, of elements and of springs.
BOOST_AUTO_TEST_CASE(st_venants_change_of_volume_is_said_where_it_shows) {
  for (const auto& [name, expected] : {std::pair("5.1", 10), std::pair("5.3", 0)}) {
    int noted = 0;
    for (const PlannedRow& row : plan_comparison(name, std::nullopt).rows)
      if (std::ranges::count(row.notes,
                             std::string(table_notes::text("st-venants-volume"))) > 0) {
        ++noted;
        BOOST_TEST(row.request.settings.material.poisson_ratio == 0.499);
      }
    BOOST_TEST(noted == expected, name);
  }
}

// The printed nu = 0 rows of 5.1 need the E-form (docs/explanation/thesis.md).
BOOST_AUTO_TEST_CASE(table_5_1_shows_the_young_modulus_form_at_nu_0_only) {
  int rows = 0;
  for (const PlannedRow& row : plan_comparison("5.1", std::nullopt).rows)
    if (row.request.settings.springs.stiffness_form ==
        mss::StiffnessForm::young_modulus) {
      ++rows;
      BOOST_TEST(row.request.settings.material.poisson_ratio == 0);
      BOOST_TEST(row.labels.back().find("E-form") != std::string::npos);
    }
  BOOST_TEST(rows == 4);  // mss-nfd and mss-cf at 5 and 20 %
}

BOOST_AUTO_TEST_CASE(a_row_holds_the_difference_its_reference_and_its_case) {
  const ComparisonPlan plan = plan_comparison("5.1", std::nullopt);
  const Comparison table = compare(plan, invented(plan, Status::ok));
  const auto json =
      nlohmann::json::parse(format_table(table_of(table), TableFormat::json));
  const auto& row = json["rows"][0];
  BOOST_TEST(row["printed"] == 2.6);
  BOOST_TEST(row["ours"].get<double>() == 3.17, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(row["difference"].get<double>() == 0.57,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(row["reference"] == "fem-stvk:q1-sri");
  BOOST_TEST(row["case"] == "0123456789abcdef");
  BOOST_TEST(row["printed_instabilities"] == "yes");
}

BOOST_AUTO_TEST_CASE(a_method_without_equilibrium_shows_its_status_in_its_cell) {
  const ComparisonPlan plan = plan_comparison("5.2", std::nullopt);
  const Comparison table = compare(plan, invented(plan, Status::no_equilibrium));
  const std::string markdown = format_table(table_of(table), TableFormat::markdown);
  BOOST_TEST(markdown.find("| no_equilibrium beyond 10 % |") != std::string::npos);
  const auto json =
      nlohmann::json::parse(format_table(table_of(table), TableFormat::json));
  BOOST_TEST(json["rows"][0]["ours"].is_null());
  BOOST_TEST(json["rows"][0]["difference"].is_null());
}

BOOST_AUTO_TEST_CASE(markdown_and_csv_are_rectangular) {
  for (const std::string& name : printed_names()) {
    const ComparisonPlan plan = plan_comparison(name, std::nullopt);
    const Comparison table = compare(plan, invented(plan, Status::ok));
    expect_rectangular(format_table(table_of(table), TableFormat::markdown),
                       format_table(table_of(table), TableFormat::csv), plan.rows.size(),
                       name);
  }
}

BOOST_AUTO_TEST_CASE(csv_keeps_all_digits_and_words_its_notes) {
  const ComparisonPlan plan = plan_comparison("5.1", std::nullopt);
  std::vector<CaseResult> results = invented(plan, Status::ok);
  results.front().measures.volume_error = 0.01171875;
  const std::string csv =
      format_table(table_of(compare(plan, results)), TableFormat::csv);
  BOOST_TEST(csv.find(",1.171875,") != std::string::npos);
  BOOST_TEST(csv.find("logarithmic strain") != std::string::npos);
  BOOST_TEST(csv.find("0123456789abcdef") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(columns_without_an_entry_are_left_out_of_markdown) {
  const ComparisonPlan plan = plan_comparison("5.3", std::nullopt);
  const std::string markdown = format_table(
      table_of(compare(plan, invented(plan, Status::ok))), TableFormat::markdown);
  BOOST_TEST(markdown.find("printed instabilities") == std::string::npos);
}

// On three grids .28, .16, .13 quarter their change: order 2, which is the formal one at
// nu = 0, with the limit .12 and the bar 2.25 * .01.
BOOST_AUTO_TEST_CASE(a_converged_reference_shows_its_order_and_bar,
                     *boost::unit_test::tolerance(1e-9)) {
  ComparisonPlan plan = plan_comparison(
      "5.1", reference_named(Given::from_text("--reference", "fem-hencky@converged")));
  plan.rows.resize(1);
  std::vector<CaseResult> results = invented(plan, Status::ok);
  BOOST_TEST_REQUIRE(results.size() == 4U);
  for (std::size_t i = 1; i < 4; ++i)
    results[i].measures.volume_error = std::array{0.28, 0.16, 0.13}.at(i - 1);
  const Comparison table = compare(plan, results);
  BOOST_TEST(*table.rows[0].reference_value == 12.);  // %
  BOOST_TEST(*table.rows[0].reference_order == 2.);
  BOOST_TEST(*table.rows[0].reference_bar == 2.25);
  const auto json =
      nlohmann::json::parse(format_table(table_of(table), TableFormat::json));
  BOOST_TEST(json["rows"][0]["reference_bar"].get<double>() == 2.25);
  BOOST_TEST(json["rows"][0]["reference_order"].get<double>() == 2.);
  const std::string text = format_table(table_of(table), TableFormat::markdown);
  BOOST_TEST(text.find("| 12.000 | 2 | 2.00 | fem-hencky:q1-sri@converged |") !=
                 std::string::npos,
             text);
}

// A figure of this program beside a reference of another's compares programs: what shares
// a reference is taken together or computed together.
BOOST_AUTO_TEST_CASE(rows_and_their_references_are_of_one_revision) {
  MeshStore meshes;
  const KnownResult known = [](const Request& request,
                               const std::string& key) -> std::optional<CaseResult> {
    const CaseSettings& settings = request.settings;
    if (settings.method.name == "mss-cf" && *settings.deformation < 0.1)
      return std::nullopt;
    CaseResult theirs{.request = request,
                      .key = "their " + key,
                      .status = Status::ok,
                      .revision = "0123456789ab"};
    theirs.measures.volume_error = 0;
    theirs.measures.plate_torque = 1;
    return theirs;
  };
  std::set<std::string> computed;
  const CatalogueEntry* const entry = &table_named("5.4");
  const ComputedTables tables = compute_tables(
      {&entry, 1}, std::nullopt, meshes, 2, known,
      [&](const CaseResult& result) { computed.insert(result.key); }, Revisions::all);
  const Comparison table = compare(plan_comparison("5.4"), tables.results);
  const double theirs = value_of(table.plan.quantity, {.plate_torque = 1}).value();
  std::size_t own = 0;
  for (const ComparisonRow& row : table.rows) {
    const bool is_own = row.result.revision.empty();
    own += is_own;
    if (row.plan.request.settings.deformation.value() > 0.1) BOOST_TEST(!is_own);
    BOOST_TEST((row.ours == std::optional(theirs)) == !is_own);
    if (row.plan.request.reference)
      BOOST_TEST((row.reference_value == std::optional(theirs)) == !is_own);
    BOOST_TEST((std::ranges::count(row.plan.notes,
                                   "Of revision 0123456789ab of the numerics.") == 1) ==
               !is_own);
  }
  BOOST_TEST(own > 1U);
  BOOST_TEST(own < table.rows.size());
  for (const std::string& key : computed) BOOST_TEST(!key.starts_with("their"));
}

BOOST_AUTO_TEST_SUITE_END()
