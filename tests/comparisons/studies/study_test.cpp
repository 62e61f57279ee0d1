#include <array>
#include <boost/test/unit_test.hpp>
#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <tuple>

#include "comparisons/methods/methods.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/running/memory.hpp"
#include "meshing/basics/breakdown.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(study_test)

namespace {

const std::vector<std::string> small{"cells=4,4,4", "method=mss-cf,fem-hooke"};

std::vector<CaseResult> study(const std::vector<Request>& requests, MeshStore& meshes,
                              int parallel, std::size_t* simulations = nullptr) {
  return run_study(requests, meshes, parallel, [&](std::size_t, std::size_t all) {
    if (simulations != nullptr) *simulations = all;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_verdict_lists_all_flags_and_takes_the_first) {
  using Flags = std::vector<Status>;
  const auto is = [](const Verdict& verdict, Status status, const Flags& flags) {
    return verdict.status == status && verdict.flags == flags;
  };
  BOOST_TEST(is(judge(SolveStatus::ok, false, false), Status::ok, {}));
  BOOST_TEST(
      is(judge(SolveStatus::ok, false, true), Status::wrinkled, {Status::wrinkled}));
  BOOST_TEST(is(judge(SolveStatus::indefinite, true, true), Status::inverted,
                {Status::inverted, Status::wrinkled, Status::indefinite}));
  BOOST_TEST(is(judge(SolveStatus::indefinite, false, false), Status::indefinite,
                {Status::indefinite}));
  BOOST_TEST(
      is(judge(SolveStatus::no_equilibrium, true, true), Status::no_equilibrium, {}));
  BOOST_TEST(is(judge(SolveStatus::refused, false, false), Status::refused, {}));
}

BOOST_AUTO_TEST_CASE(shared_simulations_run_once) {
  MeshStore meshes;
  std::vector<Request> all = requests(run_of("compression", small));
  all.push_back(all.front());
  std::size_t simulations = 0;
  const auto results = study(all, meshes, 2, &simulations);
  BOOST_TEST(simulations == 3U);  // mss-cf, fem-hooke and the reference fem-stvk
  BOOST_TEST_REQUIRE(results.size() == 3U);
  BOOST_TEST(results[0].key == results[2].key);
  BOOST_TEST(results[0].key != results[1].key);
}

// The same numbers are subtracted, so that they agree bit by bit.
BOOST_AUTO_TEST_CASE(the_deviation_is_the_displacement_less_the_reference_s) {
  MeshStore meshes;
  std::vector<std::string> against_hooke = small;
  against_hooke.emplace_back("reference=fem-hooke");
  const auto results = study(requests(run_of("compression", against_hooke)), meshes, 1);
  const CaseResult &springs = results.front(), &hooke = results.back();
  BOOST_TEST_REQUIRE(springs.deviation.size() == springs.solution.displacements.size());
  for (std::size_t n = 0; n < springs.deviation.size(); ++n)
    BOOST_TEST((springs.deviation[n] ==
                springs.solution.displacements[n] - hooke.solution.displacements[n]));
  BOOST_TEST(hooke.deviation.empty());
}

BOOST_AUTO_TEST_CASE(the_key_holds_what_deviations_are_measured_against) {
  MeshStore meshes;
  Request request = requests(run_of("compression", small)).front();
  const Mesh& mesh = meshes.mesh(request.settings.body);
  const std::string key = case_key(request, mesh);
  request.reference->elements.element = *find_element("q1");
  BOOST_TEST(case_key(request, mesh) != key);
  request.reference.reset();
  BOOST_TEST(case_key(request, mesh) != key);
}

// A reference that a file holds with its fields is not computed again.
BOOST_AUTO_TEST_CASE(known_references_are_taken_with_their_fields) {
  MeshStore meshes;
  const Request request = requests(run_of("compression", small)).front();
  const Request alone{.settings = *request.reference, .reference = std::nullopt};
  const CaseResult reference = study({alone}, meshes, 1).front();
  const CaseResult computed = study({request}, meshes, 1).front();
  std::size_t simulations = 0;
  const CaseResult result =
      run_study(
          {request}, meshes, 1, [&](std::size_t, std::size_t all) { simulations = all; },
          [&](const Request&, const std::string& key) -> std::optional<CaseResult> {
            if (key != reference.key) return std::nullopt;
            return reference;
          })
          .front();
  BOOST_TEST(simulations == 1U);
  BOOST_TEST(*result.measures.mean_deviation == *computed.measures.mean_deviation);
}

// Nothing of this program's is made of what another revision computed: a case that lacks
// some of its parts has all of them computed. Whole ones stay what they are.
BOOST_AUTO_TEST_CASE(results_of_other_revisions_are_taken_whole_or_not_at_all) {
  MeshStore meshes;
  const Request request = requests(run_of("compression", small)).front();
  const Request alone{.settings = request.settings},
      truth{.settings = *request.reference};
  const std::vector<CaseResult> computed = study({request, alone, truth}, meshes, 1);
  std::map<std::string, CaseResult> foreign;
  for (const std::size_t part : {1U, 2U}) {
    CaseResult result = computed[part];
    for (Vector3& u : result.solution.displacements) u *= 1.5;
    result.key = "in its file";
    result.revision = "0123456789ab";
    foreign.emplace(computed[part].key, std::move(result));
  }
  const KnownResult known = [&](const Request&,
                                const std::string& key) -> std::optional<CaseResult> {
    const auto found = foreign.find(key);
    return found == foreign.end() ? std::nullopt : std::optional(found->second);
  };
  const std::vector<CaseResult> results = run_study(
      {request, alone}, meshes, 1, [](std::size_t, std::size_t) {}, known);
  BOOST_TEST(results[0].key == computed[0].key);
  BOOST_TEST(results[0].revision.empty());
  BOOST_TEST((results[0].deviation == computed[0].deviation));
  BOOST_TEST(results[1].key == "in its file");
  BOOST_TEST(results[1].revision == "0123456789ab");
}

// Nearly incompressible and crushed to about half its height, the lattice folds over;
// .3 % further its path ends.
BOOST_AUTO_TEST_CASE(a_folded_cell_is_reported_inverted) {
  MeshStore meshes;
  const auto results = study(
      requests(run_of("compression",
                      {"cells=4,4,4", "method=mss-cf", "nu=0.499", "deformation=0.48"})),
      meshes, 2);
  BOOST_TEST((results.front().status == Status::inverted));
  BOOST_TEST(*results.front().measures.corner_jacobian_ratio_min < 0);
}

// The same bits whatever runs beside: every simulation is sequential in its sums.
BOOST_AUTO_TEST_CASE(results_do_not_depend_on_how_many_run_at_once) {
  MeshStore meshes;
  const auto all = requests(run_of("torsion", small));
  const auto alone = study(all, meshes, 1), together = study(all, meshes, 2);
  for (std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST((alone[i].solution.displacements == together[i].solution.displacements));
    BOOST_TEST(*alone[i].measures.plate_torque == *together[i].measures.plate_torque);
  }
}

BOOST_AUTO_TEST_CASE(a_refused_case_is_a_result_without_measures) {
  MeshStore meshes;
  const auto results =
      study(requests(run_of("compression",
                            {"size=.05,.05,.06", "cells=4,4,4", "method=mss-nfd"})),
            meshes, 1);
  BOOST_TEST((results.front().status == Status::refused));
  BOOST_TEST(results.front().reason.find("cubic") != std::string::npos);
  for_each_measure(
      results.front().measures, [](const Measure& measure, const auto& value) {
        BOOST_TEST(value.has_value() == measure.traits.is_time, measure.name);
      });
}

BOOST_AUTO_TEST_CASE(too_many_cells_are_refused_before_allocating) {
  const auto all =
      requests(run_of("compression", {"cells=2000,2000,2000", "method=mss-cf",
                                      "solver=verlet", "duration=1", "damping=0.1"}));
  BOOST_CHECK_EXCEPTION(
      check_memory("--cells", all), InputError, [](const InputError& error) {
        return std::string(error.what()).find("GB") != std::string::npos;
      });
  BOOST_CHECK_NO_THROW(check_memory("--cells", requests(run_of("compression", small))));
}

// However much memory there is, 2^31 entries are the most. A node of q1 has 27
// neighbours, one of q2 64 on average.
BOOST_AUTO_TEST_CASE(matrices_that_solvers_cannot_count_are_refused) {
  const auto refusal = [](const std::string& method, int cells) -> std::string {
    const std::string n = std::to_string(cells);
    std::vector<std::string> changes{"cells=" + n + "," + n + "," + n,
                                     "method=" + method.substr(0, method.find(':'))};
    if (method.ends_with(":q2")) changes.emplace_back("element=q2");
    std::vector<Request> all = requests(run_of("compression", changes));
    all[0].reference.reset();
    try {
      check_memory("--cells", all);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto is_counted = [&](const std::string& method, int cells) {
    return refusal(method, cells).find("entries") == std::string::npos;
  };
  BOOST_TEST(is_counted("fem-stvk", 205));
  BOOST_TEST(!is_counted("fem-stvk", 207));
  BOOST_TEST(is_counted("fem-stvk:q2", 77));
  BOOST_TEST(!is_counted("fem-stvk:q2", 78));
  BOOST_TEST(is_counted("mss-cf", 205));
  BOOST_TEST(!is_counted("mss-cf", 207));
}

// The estimates are within a tenth of the measured peaks; those of conjugate gradients by
// themselves are no less, and not more by more than a half.
BOOST_AUTO_TEST_CASE(the_estimate_is_of_the_linear_solver) {
  const auto gigabytes = [](const char* method, const char* nu, const char* cells,
                            const char* linear_solver) {
    return estimated_memory(case_of(
               "compression", {std::string("method=") + method, std::string("nu=") + nu,
                               std::string("cells=") + cells,
                               std::string("linear-solver=") + linear_solver})) /
           1e9;
  };
  const auto tenth = boost::test_tools::tolerance(.1);
  BOOST_TEST(gigabytes("mss-cf", ".4", "60,60,60", "auto") == 5.05, tenth);
  BOOST_TEST(gigabytes("mss-cf", ".4", "30,30,30", "multigrid") == .78, tenth);
  BOOST_TEST(gigabytes("mss-cf", ".4", "30,30,30", "direct") == 1.26, tenth);
  BOOST_TEST(gigabytes("mss-affine", ".4", "40,40,40", "multigrid") == 3.93, tenth);
  BOOST_TEST(gigabytes("mss-affine", ".2", "30,30,30", "multigrid") == .77, tenth);
  BOOST_TEST(gigabytes("fem-stvk", ".4", "60,60,60", "auto") == 4.62, tenth);
  for (const auto& [method, nu, cells, peak] :
       {std::tuple("mss-cf", ".25", "46,46,46", .755),
        std::tuple("mss-affine", ".4", "20,20,20", .274),
        std::tuple("fem-stvk", ".4", "30,30,30", .259)}) {
    const double estimate = gigabytes(method, nu, cells, "conjugate-gradients");
    BOOST_TEST(estimate >= peak);
    BOOST_TEST(estimate < 1.5 * peak);
  }
}

// Steps of implicit Euler factor the same tangents as statics.
BOOST_AUTO_TEST_CASE(the_estimate_counts_the_factors_of_implicit_steps) {
  const auto bytes = [](const std::string& solver) {
    std::vector<std::string> changes{"cells=30,30,30", "method=mss-cf",
                                     "solver=" + solver};
    if (solver == "static") changes.emplace_back("linear-solver=direct");
    if (solver != "static") changes.insert(changes.end(), {"duration=1", "damping=0.1"});
    return estimated_memory(case_of("compression", changes));
  };
  BOOST_TEST(bytes("implicit") == bytes("static"));
  BOOST_TEST(bytes("verlet") < bytes("static") / 3);
}

// A result that cannot be taken ends the study; simulations that run beside it are not
// left with half of their loops.
BOOST_AUTO_TEST_CASE(what_deliver_throws_ends_the_study) {
  MeshStore meshes;
  std::vector<Request> all;
  for (const char* nu : {"nu=.1", "nu=.2", "nu=.3", "nu=.4"})
    for (const Request& request :
         requests(run_of("compression", {"cells=4,4,4", "method=fem-stvk", nu})))
      all.push_back(request);
  for (int round = 0; round < 5; ++round) {
    std::vector<CaseResult> taken;
    const auto deliver = [&](std::size_t, CaseResult&& result) {
      if (!taken.empty()) throw std::runtime_error("no room");
      taken.push_back(std::move(result));
    };
    BOOST_CHECK_EXCEPTION(
        run_study(
            all, meshes, 2, [](std::size_t, std::size_t) {}, {}, deliver),
        std::runtime_error,
        [](const std::runtime_error& e) { return std::string(e.what()) == "no room"; });
    BOOST_TEST((taken.at(0).status == Status::ok));
  }
}

// What a solver throws that is no breakdown of its method, as memory that ends: it says
// nothing about the case, and the others are not lost with it.
BOOST_AUTO_TEST_CASE(a_case_without_an_answer_leaves_the_others_theirs) {
  for (const int parallel : {1, 2}) {
    MeshStore meshes;
    std::vector<Request> all = requests(
        run_of("compression", {"cells=2,2,2", "method=mss-cf,fem-hooke,mss-fd"}));
    for (Request& request : all) request.reference.reset();
    all[1].settings.method.solve = [](const auto&...) -> Solution {
      throw std::bad_alloc();
    };
    std::map<std::string, CaseResult> taken;
    std::size_t done = 0;
    BOOST_CHECK_EXCEPTION(
        run_study(
            all, meshes, parallel, [&](std::size_t now, std::size_t) { done = now; }, {},
            [&](std::size_t, CaseResult&& result) {
              const std::string name = result.request.settings.method.name;
              BOOST_TEST(taken.emplace(name, std::move(result)).second);
            }),
        NoAnswer, [](const NoAnswer& error) {
          const std::string message = error.what();
          BOOST_TEST(message.starts_with("fem-hooke:q1-sri: no answer, the memory is not "
                                         "enough (about "),
                     message);
          return message.ends_with("; 1 of 3 simulations ended so");
        });
    BOOST_TEST(taken.size() == 3U);
    for (const auto& [name, result] : taken)
      BOOST_TEST((result.status == Status::error) == (name == "fem-hooke"));
    BOOST_TEST(taken.at("fem-hooke").reason.starts_with("no answer, "));
    BOOST_TEST(!taken.at("fem-hooke").key.empty());
    BOOST_TEST(done == 3U);
  }
}

// A case whose reference has none has none either, once.
BOOST_AUTO_TEST_CASE(a_case_without_its_reference_s_answer_has_none) {
  MeshStore meshes;
  std::vector<Request> all =
      requests(run_of("compression", {"cells=2,2,2", "method=mss-cf"}));
  all[0].reference->method.solve = [](const auto&...) -> Solution {
    throw std::logic_error("a fault");
  };
  all[0].settings.method.solve = all[0].reference->method.solve;
  std::vector<Status> taken;
  BOOST_CHECK_THROW(
      run_study(
          all, meshes, 1, [](std::size_t, std::size_t) {}, {},
          [&](std::size_t, CaseResult&& result) { taken.push_back(result.status); }),
      NoAnswer);
  BOOST_TEST((taken == std::vector{Status::error}));
}

BOOST_AUTO_TEST_CASE(a_breakdown_is_an_answer) {
  CaseSettings settings = case_of("compression", {"cells=2,2,2", "method=mss-cf"});
  settings.method.solve = [](const auto&...) -> Solution {
    throw Breakdown("no step forward");
  };
  const CaseResult result = simulate(settings, MeshStore().mesh(settings.body));
  BOOST_TEST((result.status == Status::not_converged));
  BOOST_TEST(result.reason == "the solver broke down: no step forward");
}

BOOST_AUTO_TEST_SUITE_END()
