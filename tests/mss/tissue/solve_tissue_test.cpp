#include "mss/tissue/solve_tissue.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/mss/tissue/tissue_scenes.hpp"
#include "tissue/strain_history.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(solve_tissue_test)

namespace {

TissueSettings settings_of(const std::string& organ, const dynamics::LoadPath& load,
                           int steps = 50) {
  return {.solid = solid_of(organ),
          .quasi_static = {.load = load, .steps = steps},
          .protocol = std::nullopt};
}

}  // namespace

// Ramp and hold: the branches are within 3 % of the law (their fit), the steps are of
// second order.
BOOST_AUTO_TEST_CASE(a_held_body_relaxes_as_the_law_says) {
  const Mesh mesh = cube(2, h);
  const double rate = 0.133, strain = 0.5, ramp = strain / rate;
  dynamics::LoadPath load{{.time = ramp, .fraction = 1}};
  for (const double held : {0.1, 1., 10., 100.})
    load.push_back({.time = ramp + held, .fraction = 1});
  for (const char* organ : {"liver", "kidney", "spleen"}) {
    const tissue::BipowerLaw law = tissue::law_of_organ(organ);
    dynamics::Observers observers{.samples = 1};
    std::vector<double> stresses, times;
    observers.sample = [&](const dynamics::Moment& moment) {
      times.push_back(moment.time);
      stresses.push_back(mean_shear_stress(mesh, moment.reactions));
    };
    const Solution solution =
        solve_tissue(mesh, in_simple_shear(strain), settings_of(organ, load), observers);
    BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
    BOOST_TEST(solution.largest_shear_strain.value() == strain,
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST_REQUIRE(times.size() == load.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      BOOST_TEST(times[i] == load[i].time);
      const double expected =
          tissue::ramp_and_hold_stress(law, strain, rate, times[i] - ramp).total();
      BOOST_TEST(stresses[i] == expected, boost::test_tools::tolerance(0.03));
    }
  }
}

// Sheared to 100 % and back at .133 1/s. Spleen, which hardens least, is within 5 % of
// the law at half the way back; large strains that fall are up to 18 % off in kidney.
BOOST_AUTO_TEST_CASE(an_unloaded_body_is_near_the_law) {
  const Mesh mesh = cube(1, h);
  const double top = 1 / 0.133;
  const tissue::BipowerLaw law = tissue::law_of_organ("spleen");
  const tissue::StrainHistory history{.times = {0, top, 1.5 * top},
                                      .strains = {0, 1, 0.5}};
  double stress = 0;
  dynamics::Observers observers{.samples = 1};
  observers.sample = [&](const dynamics::Moment& moment) {
    stress = mean_shear_stress(mesh, moment.reactions);
  };
  const Solution solution = solve_tissue(
      mesh, in_simple_shear(1),
      settings_of("spleen",
                  {{.time = top, .fraction = 1}, {.time = 1.5 * top, .fraction = 0.5}}),
      observers);
  BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
  BOOST_TEST(solution.load_fraction == 0.5);
  BOOST_TEST(solution.largest_shear_strain.value() == 1,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(stress == tissue::stress(law, history, 1.5 * top),
             boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(motion_and_rest_take_the_same_path) {
  const Mesh mesh = cube(2, h);
  const Scene scene = between_glued_plates({0.5 * h, 0, 0});
  const dynamics::LoadPath load{{.time = 1, .fraction = 1}, {.time = 2, .fraction = 0.5}};
  TissueSettings settings = settings_of("spleen", load);
  const auto force = [&](const Solution& solution) {
    BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
    Vector3 sum = Vector3::Zero();
    for (const NodeIndex n : mesh.region("top").nodes) sum += solution.reactions[n];
    return sum.x();
  };
  const double balanced = force(solve_tissue(mesh, scene, settings));
  settings.protocol =
      dynamics::Protocol{.integrator = dynamics::Integrator::semi_implicit_euler,
                         .duration = 2,
                         .time_step = std::nullopt,
                         .step_ratio = 0.9,
                         .force_time_step = false,
                         .load = load};
  const double moved = force(solve_tissue(mesh, scene, settings));
  BOOST_TEST(moved == balanced, boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_SUITE_END()
