#include "comparisons/tables/studies/subdivision_table.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/studies/split.hpp"
#include "comparisons/tables/plans/planned_requests.hpp"

namespace springcheck {
namespace {

struct Load {
  std::string test;
  std::string amount;
  GivenSettings changes;
};

/// Beams whose tips Euler and Bernoulli drop by 5 and 20 % of the length:
/// 1.5552 m * 2 MPa/E of 2.4 m.
std::vector<Load> loads() {
  const GivenSettings coarse_cube{{"cells", std::array{4, 4, 4}}};
  std::vector<Load> all;
  for (const char* test : {"compression", "tension", "shearing"})
    for (const char* amount : {"5%", "20%"})
      all.push_back(
          {test, amount,
           GivenSettings{{"deformation", amount}} +
               (test == std::string("tension") ? GivenSettings{} : coarse_cube)});
  for (const char* amount : {"1deg", "45deg"})
    all.push_back(
        {"torsion", amount, GivenSettings{{"deformation", amount}} + coarse_cube});
  all.push_back({"bending", "5% of the length", {{"young", 25.92e6}}});
  all.push_back({"bending", "20% of the length", {{"young", 6.48e6}}});
  return all;
}

struct Parent {
  std::string cell_type;
  std::vector<std::string> children;
};
const std::vector<Parent> parents{
    {"hexahedron",
     {"tetrahedron-5", "tetrahedron", "tetrahedron-12", "prism", "pyramid"}},
    {"prism", {"tetrahedron", "tetrahedron-12"}}};

const std::vector<GivenSettings> methods_compared{
    {{"method", "mss-affine"}}, {{"method", "fem-hencky"}, {"element", "q1"}}};

struct PlannedPair {
  Load load;
  std::string parent_type, child_type;
  std::size_t parent, child;  // places of simulations
};

/// Root mean square over the parent's nodes, which the child has too under the same
/// numbers, over the largest displacement of the parent.
std::optional<double> deviation(const CaseResult& parent, const CaseResult& child) {
  const std::vector<Vector3>&u = parent.solution.displacements,
        &v = child.solution.displacements;
  if (!parent.measures.volume_error || !child.measures.volume_error) return std::nullopt;
  double squares = 0, largest = 0;
  for (std::size_t n = 0; n < u.size(); ++n) {
    squares += (v[n] - u[n]).squaredNorm() / static_cast<double>(u.size());
    largest = std::max(largest, u[n].norm());
  }
  return std::sqrt(squares) / largest;
}

Cell change_cell(const std::optional<double>& of_child,
                 const std::optional<double>& of_parent, const CaseResult& child) {
  if (!of_child || !of_parent) return value_or_status(std::nullopt, child);
  return {100 * (*of_child / *of_parent - 1)};
}

TableRow row_of(const PlannedPair& pair, std::span<const CaseResult> results) {
  const CaseResult &parent = results[pair.parent], &child = results[pair.child];
  const SplitMeasure answer = answer_to_load(child.request.settings.test).value();
  const auto &volume = child.measures.volume_change,
             &parent_volume = parent.measures.volume_change;
  const auto off = deviation(parent, child);
  return {
      .cells = {label(child.request.settings), pair.load.test, pair.load.amount,
                pair.parent_type, pair.child_type,
                change_cell(answer.of(child.measures), answer.of(parent.measures), child),
                volume && parent_volume ? Cell{100 * (*volume - *parent_volume)}
                                        : value_or_status(std::nullopt, child),
                off ? Cell{100 * *off} : value_or_status(std::nullopt, child),
                name_of(child.status), name_of(parent.status)},
      .cases = {child.key, parent.key}};
}

}  // namespace

TablePlan plan_subdivision_table() {
  PlannedRequests requests;
  std::vector<PlannedPair> pairs;
  for (const GivenSettings& method : methods_compared)
    for (const Load& load : loads()) {
      const auto add = [&](const std::string& cell_type) {
        return requests.add(
            load.test, load.changes + method + GivenSettings{{"cell-type", cell_type}});
      };
      for (const Parent& parent : parents) {
        const std::size_t place = add(parent.cell_type);
        for (const std::string& child : parent.children)
          pairs.push_back({load, parent.cell_type, child, place, add(child)});
      }
    }
  return {
      .requests = requests.take(),
      .make = [pairs](std::span<const CaseResult> results, MeshStore&) {
        Table table{
            .columns = {{"method", "method"},
                        {"test", "test"},
                        {"amount", "deformation"},
                        {"parent", "parent"},
                        {"cells", "cut into"},
                        {"answer", "force, torque or tip off the parent's [%]", "{:.2f}"},
                        {"volume", "volume off [points]", "{:.3f}"},
                        {"deviation", "deviation [%]", "{:.3f}"},
                        {"status", "status"},
                        {"parent_status", "parent's"}},
            .notes = {"Cubes of 4 x 4 x 4 hexahedra, beams of 4 x 4 x 24. Deviation: "
                      "root mean square over the parent's nodes, over its largest "
                      "displacement. Source of the subdivisions: Golec 2018, section "
                      "6.1; of prisms into three tetrahedra (tetrahedron) and six "
                      "(tetrahedron-12)."}};
        for (const PlannedPair& pair : pairs) table.rows.push_back(row_of(pair, results));
        return table;
      }};
}

}  // namespace springcheck
