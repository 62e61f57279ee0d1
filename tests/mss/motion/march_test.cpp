#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

#include "mss/forces/forces.hpp"
#include "tests/mss/spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Checkpoint;
using dynamics::Integrator;
using dynamics::Moment;
using dynamics::Observers;

BOOST_AUTO_TEST_SUITE(march_test)

namespace {

constexpr double h = 0.005;  // [m]

/// A body, what holds it, and its springs.
struct Body {
  Mesh mesh;
  Scene scene;
  Network network;
};

Body pressed_cube(int n, double nu, double strain, SpringModel model = SpringModel::cf,
                  StrainMeasure measure = StrainMeasure::engineering) {
  Mesh mesh = cube(n, h);
  Scene scene = between_plates(tissue_of(nu), {0, 0, -strain * n * h});
  Network network = build_network(mesh, scene.material, springs_in(measure, model));
  return {std::move(mesh), std::move(scene), std::move(network)};
}

Solution run(const Body& body, const DynamicsSettings& settings,
             const Observers& observers = {}) {
  return run_dynamics(body.mesh, body.scene, body.network, settings, observers);
}

bool same_bits(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector3)) == 0;
}

void check_same(const Solution& a, const Solution& b) {
  BOOST_TEST(same_bits(a.displacements, b.displacements));
  BOOST_TEST(same_bits(a.reactions, b.reactions));
  BOOST_TEST(*a.kinetic_energy == *b.kinetic_energy);
  BOOST_TEST(a.strain_energy == b.strain_energy);
  BOOST_TEST(a.steps == b.steps);
  BOOST_TEST(*a.dt == *b.dt);
  BOOST_TEST(*a.dt_limit == *b.dt_limit);
}

/// What a run saved after each of these steps.
std::vector<Checkpoint> checkpoints(const Body& body, const DynamicsSettings& settings,
                                    const std::vector<int>& after) {
  std::vector<Checkpoint> saved;
  run(body, settings,
      {.checkpoint =
           [&](const Checkpoint& now) {
             if (std::ranges::count(after, now.step) > 0) saved.push_back(now);
           },
       .seconds_between_checkpoints = 0});
  BOOST_TEST_REQUIRE(saved.size() == after.size());
  return saved;
}

void check_goes_on_to_the_bit(const Body& body, const DynamicsSettings& settings,
                              const std::vector<int>& after) {
  const Solution whole = run(body, settings);
  BOOST_TEST_REQUIRE((whole.status == SolveStatus::ok), whole.reason);
  for (const Checkpoint& from : checkpoints(body, settings, after))
    BOOST_TEST_CONTEXT("after step " << from.step) {
      check_same(run(body, settings, {.from = from}), whole);
    }
}

double limit_of(const Body& body, double zeta) {
  return largest_stable_step(
      body.network, zeta,
      free_components(body.mesh, prescribed_components(body.mesh, body.scene)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_goes_on_from_a_checkpoint_to_the_bit) {
  const Body body = pressed_cube(3, 0.4, 0.05);
  for (const auto& [name, integrator] : all_integrators) BOOST_TEST_CONTEXT(name) {
      const bool is_implicit = integrator == Integrator::implicit_euler;
      check_goes_on_to_the_bit(
          body, settings_of(integrator, 0.02, is_implicit ? 1e-3 : 1e-4, 0.2),
          is_implicit ? std::vector{1, 11} : std::vector{1, 77, 199});
    }
}

// The limit is looked at 40 times on the way; to 20 % of compression the step becomes
// longer by a fifth: behind a checkpoint, in the very step of a look, and before one. The
// motion that the next look starts from comes back as well.
BOOST_AUTO_TEST_CASE(a_run_whose_step_changes_goes_on_to_the_bit) {
  const Body body = pressed_cube(3, 0.4, 0.2);
  for (const Precision precision :
       {Precision::double_precision, Precision::single_precision})
    for (const Integrator integrator :
         {Integrator::semi_implicit_euler, Integrator::verlet}) {
      DynamicsSettings settings = settings_of(integrator, 3, std::nullopt, 0.1);
      settings.precision = precision;
      const std::vector<Checkpoint> saved =
          checkpoints(body, settings, {1000, 2999, 3000, 3210});
      BOOST_TEST(!saved[0].stiffest.empty());
      BOOST_TEST(saved[3].dt > 1.02 * saved[0].dt);
      check_goes_on_to_the_bit(body, settings, {1000, 2999, 3000, 3210});
    }
}

// Single precision moves nodes by roundings of 6e-8 of where they are, thousands of times
// over, and forces by 2e-6 of k L: 1e-5 of the way all the same.
BOOST_AUTO_TEST_CASE(single_precision_ends_where_double_does) {
  const Body body = pressed_cube(6, 0.4, 0.1);
  DynamicsSettings settings = settings_of(Integrator::semi_implicit_euler, 1, 5e-4, 0.1);
  const Solution fine = run(body, settings);
  settings.precision = Precision::single_precision;
  const Solution rough = run(body, settings);
  double largest = 0;
  for (std::size_t n = 0; n < fine.displacements.size(); ++n)
    largest = std::max(largest, (rough.displacements[n] - fine.displacements[n]).norm());
  BOOST_TEST(largest > 0);
  BOOST_TEST(largest < 1e-5 * 0.1 * 6 * h);
}

BOOST_AUTO_TEST_CASE(samples_are_at_equal_distances_and_end_with_the_state_returned) {
  const Body body = pressed_cube(3, 0.25, 0.05);
  for (const auto& [name, integrator] : all_integrators) BOOST_TEST_CONTEXT(name) {
      std::vector<Moment> moments;
      const Solution end = run(
          body, settings_of(integrator, 0.1, 1e-4, 0.2),
          {.samples = 8, .sample = [&](const Moment& now) { moments.push_back(now); }});
      BOOST_TEST_REQUIRE(moments.size() == 8U);
      for (std::size_t i = 0; i < 8; ++i) {
        const double due = 0.1 * (static_cast<double>(i) + 1) / 8;
        BOOST_TEST(std::abs(moments[i].time - due) <= 1.001e-4);
        BOOST_TEST(moments[i].load_fraction == moments[i].time / 0.1);
      }
      BOOST_TEST(moments.back().time == 0.1);
      BOOST_TEST(same_bits(moments.back().displacements, end.displacements));
      BOOST_TEST(same_bits(moments.back().reactions, end.reactions));
      BOOST_TEST(moments.back().kinetic_energy == *end.kinetic_energy);
    }
}

// A body that is not a number by step 250 is seen at step 300.
BOOST_AUTO_TEST_CASE(positions_that_are_no_numbers_end_the_run_within_100_steps) {
  const Body body = pressed_cube(3, 0.25, 0.05);
  for (const auto& [name, integrator] : explicit_integrators)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e3}) {
      const DynamicsSettings settings = settings_of(integrator, 0.1, 1e-4, 0.2);
      Checkpoint from = checkpoints(body, settings, {250}).front();
      from.state.velocities[21].x() = bad / 1e-4;
      const Solution end = run(body, settings, {.from = from});
      BOOST_TEST((end.status == SolveStatus::diverged));
      BOOST_TEST(end.steps == 300);
      BOOST_TEST(end.reason.find("by step 300 of 1000") != std::string::npos, end.reason);
    }
}

BOOST_AUTO_TEST_CASE(a_forced_step_above_the_limit_ends_diverged) {
  const Body body = pressed_cube(3, 0.25, 0.05);
  for (const auto& [name, integrator] : explicit_integrators)
    for (const Precision precision :
         {Precision::double_precision, Precision::single_precision})
      BOOST_TEST_CONTEXT(name) {
        const double dt = 1.5 * limit_of(body, 0);
        DynamicsSettings settings = settings_of(integrator, 2000 * dt, dt, 0);
        settings.precision = precision;
        const Solution refused = run(body, settings);
        BOOST_TEST((refused.status == SolveStatus::refused));
        const std::string cause = integrator == Integrator::explicit_euler
                                      ? "without dashpots (--damping)"
                                      : "nu = 0.25, cells of 0.005 m";
        BOOST_TEST(refused.reason.find(cause) != std::string::npos, refused.reason);
        settings.protocol.force_time_step = true;
        const Solution forced = run(body, settings);
        BOOST_TEST((forced.status == SolveStatus::diverged));
        BOOST_TEST(forced.steps < 2000);
        BOOST_TEST(forced.steps % 100 == 0);
        BOOST_TEST(forced.reason.find("by step " + std::to_string(forced.steps)) !=
                       std::string::npos,
                   forced.reason);
      }
}

// Near nu = .5 the limit falls within a few hundred steps: that at rest is, for all the
// way, too long for mss-cf. mss-affine bears it to 20 %, and its looks are of another
// kernel.
BOOST_AUTO_TEST_CASE(an_open_step_follows_the_limit_in_short_runs_too) {
  for (const auto& [model, nu, strain, duration] :
       {std::tuple(SpringModel::cf, .49, .2, .1),
        {SpringModel::cf, .499, .3, .1},
        {SpringModel::affine, .499, .2, .05}}) {
    const Body body = pressed_cube(4, nu, strain, model);
    const DynamicsSettings settings =
        settings_of(Integrator::semi_implicit_euler, duration, std::nullopt, .05);
    const Solution end = run(body, settings);
    BOOST_TEST_CONTEXT("nu " << nu << ", strain " << strain) {
      BOOST_TEST((end.status == SolveStatus::ok), end.reason);
      BOOST_TEST(end.steps < 1200);
      BOOST_TEST(end.force_evaluations > 1.1 * end.steps);  // looks are counted
      DynamicsSettings held = settings;
      held.protocol.time_step = .9 * limit_of(body, .05);
      if (model == SpringModel::cf)
        BOOST_TEST((run(body, held).status == SolveStatus::diverged));
      check_goes_on_to_the_bit(body, settings, {end.steps / 3, end.steps / 2});
    }
  }
}

// The user's step is not changed. It is above the limit of the body as it is then, and
// what grows has no time to become large.
BOOST_AUTO_TEST_CASE(a_step_that_comes_to_lie_above_the_limit_is_named) {
  const Body body = pressed_cube(4, .49, .2);
  DynamicsSettings settings = settings_of(Integrator::semi_implicit_euler, .1, 0, .05);
  settings.protocol.time_step = .9 * limit_of(body, .05);
  std::vector<Checkpoint> seen;
  run(body, settings,
      {.checkpoint = [&](const Checkpoint& now) { seen.push_back(now); },
       .seconds_between_checkpoints = 0});
  const auto first = std::ranges::find_if(
      seen, [](const Checkpoint& now) { return now.excess.has_value(); });
  BOOST_TEST_REQUIRE((first != seen.end()));
  BOOST_TEST(first->step == first->excess->step);
  BOOST_TEST(first->limit < first->dt);
  BOOST_TEST(first->limit == first->excess->limit);
  Checkpoint near_end = *first;
  near_end.steps_left = 3;
  near_end.time = settings.protocol.duration - 3 * near_end.dt;
  const Solution end = run(body, settings, {.from = near_end});
  BOOST_TEST((end.status == SolveStatus::ok), end.reason);
  BOOST_TEST(end.reason.find("of the strained body from step " +
                             std::to_string(first->step) + " on") != std::string::npos,
             end.reason);
}

// Dashpots and the springs' nonlinearity hold what grows: positions stay near, and plate
// forces are of the wrong sign.
BOOST_AUTO_TEST_CASE(a_held_instability_ends_diverged) {
  const Body body = pressed_cube(4, .499, .05, SpringModel::affine);
  const double dt = 1.02 * limit_of(body, 1);
  DynamicsSettings settings = settings_of(Integrator::verlet, 20000 * dt, dt, 1);
  settings.protocol.force_time_step = true;
  const Solution end = run(body, settings);
  BOOST_TEST((end.status == SolveStatus::diverged));
  BOOST_TEST(end.steps < 2000);
  BOOST_TEST(
      end.reason.find("turned round from step to step by step " +
                      std::to_string(end.steps) + " of 20000") != std::string::npos,
      end.reason);
  BOOST_TEST(end.reason.find("of the body at rest from step 0 on") != std::string::npos,
             end.reason);
}

// The mean of those half a step before and after: a motion that every step turns round
// has velocities of zero in between. Rounding of sums, and of forces by plain loops.
BOOST_AUTO_TEST_CASE(kinetic_energy_of_verlet_is_the_mean_of_half_steps) {
  Body body = pressed_cube(2, .25, 0);
  body.scene = in_free_space(tissue_of(.25));
  const double dt = .9 * limit_of(body, 0);
  const std::size_t nodes = body.mesh.nodes().size();
  std::vector<double> sampled, half_steps;
  run(body, settings_of(Integrator::verlet, 12 * dt, dt, 0),
      {.samples = 12,
       .sample = [&](const Moment& now) { sampled.push_back(now.kinetic_energy); },
       .checkpoint =
           [&](const Checkpoint& now) {
             half_steps.push_back(0);
             for (std::size_t n = 0; n < nodes; ++n)
               half_steps.back() +=
                   body.network.masses[n] / 2 * now.state.velocities[n].squaredNorm();
           },
       .seconds_between_checkpoints = 0,
       .from = Checkpoint{.state = {.displacements = random_field(nodes, 1e-3 * h, 1),
                                    .velocities = random_field(nodes, 1e-3, 2)},
                          .dt = dt,
                          .last_dt = dt,
                          .steps_left = 12,
                          .limit = dt / .9}});
  BOOST_TEST_REQUIRE(sampled.size() == 12U);
  BOOST_TEST_REQUIRE(half_steps.size() == 11U);
  for (std::size_t n = 0; n + 1 < half_steps.size(); ++n)
    BOOST_TEST(sampled[n] == (half_steps[n] + half_steps[n + 1]) / 2,
               boost::test_tools::tolerance(1e-11));
}

namespace {

void check_keeps_its_energy(Body body) {
  body.scene = in_free_space(tissue_of(0.4));
  const std::size_t nodes = body.mesh.nodes().size();
  const double dt = 0.5 * limit_of(body, 0);
  const dynamics::State start{.displacements = random_field(nodes, 0.02 * h, 1),
                              .velocities = random_field(nodes, 0.01, 2)};
  const auto energies = [&](Integrator integrator) {
    std::vector<double> list;
    run(body, settings_of(integrator, 5000 * dt, dt, 0),
        {.samples = 5000,
         .sample =
             [&](const Moment& now) {
               list.push_back(now.kinetic_energy + now.strain_energy);
             },
         .from =
             Checkpoint{.state = start, .dt = dt, .steps_left = 5000, .limit = 2 * dt}});
    return list;
  };
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::verlet}) {
    const std::vector<double> list = energies(integrator);
    BOOST_TEST_REQUIRE(list.size() == 5000U);
    const auto mean = [&](std::size_t from) {
      double sum = 0;
      for (std::size_t n = from; n < from + 1000; ++n) sum += list[n];
      return sum / 1000;
    };
    BOOST_TEST(mean(4000) == mean(0), boost::test_tools::tolerance(0.01));
    const auto [low, high] = std::ranges::minmax(list);
    const double swing = integrator == Integrator::verlet ? 0.25 : 1;
    BOOST_TEST(high - low < swing * mean(0));
  }
  BOOST_TEST(energies(Integrator::explicit_euler).size() < 5000U);
}

}  // namespace

// Energies of a symplectic scheme swing and do not drift: their means over the first and
// the last thousand steps agree to 1 %, while explicit Euler's grow without end. At omega
// dt = 1, half the limit, a mode's energy swings by up to (omega dt)^2/2 of it with
// Verlet: that of x_n and v_n by half as much, which the mean of half steps doubles,
// and all modes together by less than half of that; semi-implicit Euler's velocities are
// in truth those of half a step before, which adds omega dt/2 to either side.
BOOST_AUTO_TEST_CASE(an_undamped_run_keeps_its_energy) {
  for (const StrainMeasure measure : all_measures)
    check_keeps_its_energy(pressed_cube(3, 0.4, 0, SpringModel::cf, measure));
}

BOOST_AUTO_TEST_SUITE_END()
