#include "meshing/basics/random_numbers.hpp"

#include <dlfcn.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <future>

#include "comparisons/running/simulate.hpp"
#include "tests/comparisons/settings.hpp"

// Whatever draws from the one stream of random numbers that libc has for a process holds
// its mutex meanwhile: METIS's orderings, and with them the last digits of direct
// solvers, would otherwise depend on what runs beside them.

namespace {

constexpr int looked_at = 200;  // draws of a simulation: each starts a thread
std::atomic<int> draws, draws_of_others;

bool is_held() {
  return std::async(std::launch::async,
                    [] {
                      const std::unique_lock lock(springcheck::random_numbers(),
                                                  std::try_to_lock);
                      return !lock.owns_lock();
                    })
      .get();
}

}  // namespace

/// Stands in place of libc's rand in this whole process.
extern "C" int rand() noexcept {
  static const auto of_libc = reinterpret_cast<int (*)()>(dlsym(RTLD_NEXT, "rand"));
  if (draws++ < looked_at && !is_held()) ++draws_of_others;
  return of_libc();
}

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(random_numbers_test)

namespace {

/// Whether it drew, and always under the mutex.
bool draws_alone(const std::string& scene, const std::vector<std::string>& changes) {
  draws = draws_of_others = 0;
  const CaseSettings settings = case_of(scene, changes);
  const CaseResult result = simulate(settings, build_mesh(settings.body));
  BOOST_TEST(!result.solution.displacements.empty());
  return draws > 0 && draws_of_others == 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_draw_without_the_mutex_is_noticed) {
  draws = draws_of_others = 0;
  static_cast<void>(std::rand());
  BOOST_TEST(draws == 1);
  BOOST_TEST(draws_of_others == 1);
}

// Meshes of which CHOLMOD finds METIS's ordering worth a try.
BOOST_AUTO_TEST_CASE(direct_solvers_draw_alone) {
  BOOST_TEST(draws_alone("compression", {"method=fem-hooke", "element=q1",
                                         "cells=12,12,12", "linear-solver=direct"}));
  BOOST_TEST(draws_alone("compression", {"method=mss-nfd", "cells=14,14,14"}));
  BOOST_TEST(
      draws_alone("compression", {"method=mss-nfd", "cells=14,14,14", "solver=implicit",
                                  "duration=1", "dt=1", "deformation=0.1%"}));
}

// The products of multigrid take no lock.
BOOST_AUTO_TEST_CASE(multigrid_draws_nothing) {
  (void)draws_alone("compression",
                    {"method=fem-hooke", "cells=12,12,12", "linear-solver=multigrid"});
  BOOST_TEST(draws == 0);
}

BOOST_AUTO_TEST_CASE(gmsh_draws_alone) {
  BOOST_TEST(draws_alone("kidney", {"method=fem-hooke", "cells=2,2,2"}));
}

BOOST_AUTO_TEST_SUITE_END()
