#define BOOST_TEST_MODULE split_reference
#include <boost/test/unit_test.hpp>

#include "comparisons/split.hpp"
#include "settings.hpp"

using namespace springcheck;

namespace {

/// Percent: springs on the scene's mesh, converged Cauchy-Born, converged Hencky.
struct Stored {
  const char* deformation;
  double springs, cauchy_born, hencky;
};

Split split_of(const CaseSettings& springs) {
  const SplitPlan plan = plan_split(springs, *find_method("fem-hencky"));
  std::vector<Request> all{{.settings = springs, .reference = std::nullopt}};
  const auto grids = split_requests(plan);
  all.insert(all.end(), grids.begin(), grids.end());
  MeshStore meshes;
  const auto results = run_study(all, meshes, 1, [](std::size_t, std::size_t) {});
  return split_error(plan, results.front(), std::span(results).subspan(1), meshes);
}

}  // namespace

// Volume errors in tension, nu = 1/4, from independent prototypes: Aitken extrapolation
// of q1 on the same grids. Band: .02 points, the error bars of the converged values.
BOOST_AUTO_TEST_CASE(tension_is_split_as_an_independent_program_split_it) {
  for (const auto& [deformation, springs, cauchy_born, hencky] :
       {Stored{"5%", 2.505, 2.468, 2.553}, Stored{"20%", 8.761, 8.600, 9.876}}) {
    const Split split =
        split_of(case_of("tension", {"method=mss-cf", "nu=0.25",
                                     std::string("deformation=") + deformation}));
    for (const SplitQuantity& quantity : split.quantities)
      BOOST_TEST(quantity.is_resolved(), quantity.name);
    const SplitQuantity& volume = split.quantities.front();
    const auto expect = [](const std::optional<double>& found, double percent) {
      BOOST_TEST_REQUIRE(found.has_value());
      BOOST_TEST(std::abs(100 * *found - percent) < 0.02,
                 100 * *found << " instead of " << percent);
    };
    expect(volume.springs, springs);
    expect(volume.cauchy_born.converged.value, cauchy_born);
    expect(volume.reference.converged.value, hencky);
    expect(volume.law.value, cauchy_born - hencky);
    expect(volume.discretisation.value, springs - cauchy_born);
    // Clamped edges are singular: between first and second order.
    BOOST_TEST(*volume.cauchy_born.converged.order > 1);
    BOOST_TEST(*volume.cauchy_born.converged.order < 2);
  }
}
