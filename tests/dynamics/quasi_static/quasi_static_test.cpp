#include "dynamics/quasi_static/quasi_static.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
using namespace springcheck::dynamics;

BOOST_AUTO_TEST_SUITE(quasi_static_test)

namespace {

constexpr double h = 1;  // [m]

/// Two cells, one on the other: the nodes between them are free.
Mesh column() {
  return generate_block({.size = {h, h, 2 * h}, .cells = {1, 1, 2}});
}

Scene pressed() {
  const auto moved = [](double z) {
    return RigidMotion{.translation = {0, 0, z},
                       .axis = Vector3::UnitZ(),
                       .centre = Vector3::Zero(),
                       .angle = 0};
  };
  return {.material = {.young_modulus = 1, .poisson_ratio = 0.25, .density = 1},
          .plates = {{"bottom", moved(0), all_components},
                     {"top", moved(-h), all_components}},
          .gravity = Vector3::Zero()};
}

/// Every free node has the energy
///
///     W = k/2 (y^2 + z^2) + k/2 (1 - 2 s) x^2 + k b/4 x^4 + k c/6 x^6,   k = 1, h = 1
///
/// of its displacement, s the load fraction as the upper plate tells it. At x = 0 it is
/// stable up to s = 1/2; beyond, x^2 = (2 s - 1)/b is, if b > 0 and c = 0. With b < 0 the
/// next stable state is at a distance, x^2 = -b/c at s = 1/2.
class Pitchfork final : public RememberingBody {
 public:
  Pitchfork(const Mesh& mesh, double b, double c = 0)
      : rest_(mesh.nodes()), b_(b), c_(c) {
    for (NodeIndex n = 0; n < rest_.size(); ++n) {
      if (rest_[n].z() == 2 * h) top_ = n;
      if (rest_[n].z() == h) free_.push_back(n);
    }
  }

  [[nodiscard]] std::vector<Vector3> load() const override {
    return std::vector<Vector3>(rest_.size(), Vector3::Zero());
  }
  [[nodiscard]] statics::Patches patches() const override {
    statics::Patches patches;
    for (NodeIndex n = 0; n < rest_.size(); ++n) patches.push_back({n});
    return patches;
  }
  [[nodiscard]] Forces forces_after(double, std::span<const Vector3> positions) override {
    std::vector<Vector3> forces = load();
    for (const NodeIndex n : free_) {
      const Vector3 u = positions[n] - rest_[n];
      forces[n] = -u;
      forces[n].x() = -(1 - 2 * fraction(positions)) * u.x() - b_ * std::pow(u.x(), 3) -
                      c_ * std::pow(u.x(), 5);
    }
    return {.on_nodes = std::move(forces), .scale = 1};
  }
  void assemble_tangent(double, std::span<const Vector3> positions,
                        statics::BlockMatrix& tangent) override {
    tangent.assemble([&](std::size_t n) -> Eigen::MatrixXd {
      const double x = positions[n].x() - rest_[n].x();
      const double along_x =
          1 - 2 * fraction(positions) + 3 * b_ * x * x + 5 * c_ * std::pow(x, 4);
      return Vector3(along_x, 1, 1).asDiagonal();
    });
  }
  void advance(double, std::span<const Vector3>) override {}
  [[nodiscard]] double free_energy(std::span<const Vector3>) const override { return 0; }
  [[nodiscard]] double largest_shear_strain(std::span<const Vector3>) const override {
    return 0;
  }

  [[nodiscard]] const std::vector<NodeIndex>& free() const { return free_; }

 private:
  [[nodiscard]] double fraction(std::span<const Vector3> positions) const {
    return (rest_[top_].z() - positions[top_].z()) / h;
  }

  std::vector<Vector3> rest_;
  double b_, c_;
  NodeIndex top_ = 0;
  std::vector<NodeIndex> free_;
};

Solution solution_of(Pitchfork& body, double load) {
  return find_quasi_static(column(), pressed(), body,
                           {.load = {{.time = 1, .fraction = load}}, .steps = 20});
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_stays_stable_is_ok_and_says_nothing) {
  Pitchfork body(column(), 1);
  const Solution solution = solution_of(body, 0.49);
  BOOST_TEST((solution.status == SolveStatus::ok));
  BOOST_TEST(solution.reason.empty());
  BOOST_TEST(!solution.definite_up_to);
}

// Steps of .05: the last stable one ends at .45, as .5 has no curvature.
BOOST_AUTO_TEST_CASE(a_body_that_buckles_finds_the_stable_branch_and_tells_it) {
  Pitchfork body(column(), 4);
  const Solution solution = solution_of(body, 1);
  BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
  BOOST_TEST(solution.load_fraction == 1);
  BOOST_TEST(solution.reason.ends_with("of the load, but is again at the end"));
  BOOST_TEST_REQUIRE(solution.definite_up_to.has_value());
  BOOST_TEST(*solution.definite_up_to <= 0.5);
  BOOST_TEST(*solution.definite_up_to > 0.4);
  for (const NodeIndex n : body.free())  // x^2 = 1/4
    BOOST_TEST(std::abs(solution.displacements[n].x()) == 0.5,
               boost::test_tools::tolerance(1e-8));
  Pitchfork again(column(), 4);
  const Solution other = solution_of(again, 1);
  for (const NodeIndex n : body.free())
    BOOST_TEST(other.displacements[n].x() == solution.displacements[n].x());
}

// There is no stable state beside it: the path goes on as it is, and is judged.
BOOST_AUTO_TEST_CASE(an_equilibrium_without_a_stable_one_near_is_indefinite) {
  Pitchfork body(column(), 0);
  const Solution solution = solution_of(body, 1);
  BOOST_TEST((solution.status == SolveStatus::indefinite), solution.reason);
  BOOST_TEST(solution.load_fraction == 1);
  BOOST_TEST(solution.reason.starts_with("the tangent is not positive definite beyond"));
  BOOST_TEST(*solution.definite_up_to <= 0.5);
  BOOST_TEST(*solution.definite_up_to > 0.4);
  for (const NodeIndex n : body.free()) BOOST_TEST(solution.displacements[n].x() == 0);
}

// The jump would be to x = 2: no path leads there, however short the steps; they are
// halved to .0008.
BOOST_AUTO_TEST_CASE(a_jump_to_another_branch_is_the_end_of_the_path) {
  Pitchfork body(column(), -1, .25);
  const Solution solution = solution_of(body, 1);
  BOOST_TEST((solution.status == SolveStatus::no_equilibrium), solution.reason);
  BOOST_TEST(solution.reason.find("on another branch") != std::string::npos,
             solution.reason);
  BOOST_TEST(solution.load_fraction == .5, boost::test_tools::tolerance(.002));
  for (const NodeIndex n : body.free()) BOOST_TEST(solution.displacements[n].x() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
