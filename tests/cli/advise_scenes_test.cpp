#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/cli/program.hpp"

BOOST_AUTO_TEST_SUITE(advise_scenes_test)

// Advice for the thesis's five scenes, held against q2 on cells finer than those that
// the advice knew.

namespace {

struct Scene {
  std::string name, answer;
  int truth;                // across the coarsest of the advice's three grids
  std::string finer_cells;  // than the finest of them
};

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  return out << scene.name;
}

const std::vector<Scene> scenes{
    {"compression", "plate_force", 2, "10,10,10"},
    {"tension", "plate_force", 1, "6,6,36"},
    {"shearing", "plate_force", 2, "10,10,10"},
    {"torsion", "plate_torque", 2, "10,10,10"},
    {"bending", "tip_deflection", 1, "6,6,36"},
};

double answer_of(const Scene& scene, const std::string& run) {
  const Run ran = run_springcheck("run " + run + " --json");
  BOOST_TEST(ran.status == 0, ran.err);
  const Json result = Json::parse(ran.out)["results"][0];
  BOOST_TEST(result["status"] == "ok");
  return result[scene.answer];
}

}  // namespace

BOOST_DATA_TEST_CASE(advice_holds_beside_a_finer_truth,
                     boost::unit_test::data::make(scenes)) {
  const double finer =
      answer_of(sample, sample.name + " --method fem-stvk --element q2 --cells " +
                            sample.finer_cells);
  for (const double tolerance : {0.2, 0.08}) {
    const Run run = run_springcheck(
        "advise " + sample.name + " --out " + sample.name + ".h5 --converged-across " +
        std::to_string(sample.truth) + " --tolerance " + std::to_string(tolerance));
    BOOST_TEST(run.status == 0, run.out + run.err);
    BOOST_TEST_MESSAGE(run.out);
    const double advised = answer_of(sample, "./" + sample.name + "-advised.toml");
    BOOST_TEST(std::abs(advised / finer - 1) <= tolerance, run.out);
  }
}

BOOST_AUTO_TEST_SUITE_END()
