#include <boost/test/unit_test.hpp>

#include "comparisons/studies/study.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(tissue_springs_and_elements_test)

// Glued plates and free sides: nothing is homogeneous. Springs and finite elements of the
// same law on the same cubes; both converge to the same, springs from 4^3 cells.
BOOST_AUTO_TEST_CASE(springs_and_elements_of_a_law_agree) {
  MeshStore meshes;
  const auto results = [&](const std::string& scene, const std::string& cells) {
    return run_study(
        requests(run_of(scene,
                        {"method=mss-tissue,fem-tissue", "organ=spleen", "rate=.133",
                         "time-steps=10", "nu=.45", "deformation=.2", "cells=" + cells})),
        meshes, 1, [](std::size_t, std::size_t) {});
  };
  for (const char* scene : {"compression", "shearing"}) {
    const auto off = [&](const std::string& cells) {
      const auto both = results(scene, cells);
      for (const CaseResult& result : both)
        BOOST_TEST((result.status == Status::ok), result.reason);
      return std::abs(*both[0].measures.plate_force / *both[1].measures.plate_force - 1);
    };
    const double coarse = off("4,4,4"), fine = off("8,8,8");
    BOOST_TEST_MESSAGE(scene << ": " << coarse << ", " << fine);
    BOOST_TEST(fine < coarse);
    BOOST_TEST(fine < 0.03);
  }
}

BOOST_AUTO_TEST_SUITE_END()
