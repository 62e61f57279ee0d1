#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "comparisons/methods/methods.hpp"
#include "comparisons/studies/study.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/referee/figures.hpp"

// The scenes uniaxial, traction and affine from file to measure, for springs and finite
// elements, against closed forms.

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(homogeneous_scenes_test)

namespace {

constexpr double E = 10e3, area = 0.05 * 0.05;  // of the shipped scenes

CaseResult any_result_of(const std::string& scene, std::vector<std::string> changes) {
  changes.emplace_back("cells=3,3,3");
  MeshStore meshes;
  return run_study({{case_of(scene, changes), std::nullopt}}, meshes, 1,
                   [](std::size_t, std::size_t) {})
      .front();
}

/// The result of a case that must be ok.
CaseResult result_of(const std::string& scene, const std::vector<std::string>& changes) {
  CaseResult result = any_result_of(scene, changes);
  BOOST_TEST_REQUIRE((result.status == Status::ok), name_of(result.status)
                                                        << ": " << result.reason);
  return result;
}

std::string number(const char* key, double value) {
  return key + std::string("=") + nlohmann::json(value).dump();
}

/// A law in uniaxial stress: force per undeformed area [Pa] and V/V0, by the stretch.
struct Law {
  std::string method;
  std::function<double(double z, double nu)> stress;
  std::function<double(double z, double nu)> volume_ratio;
};

// St-Venant-Kirchhoff has S = E e along the axis, e = (z^2 - 1)/2, and -nu e across it.
// Hencky has the Kirchhoff stress E ln z, and the logarithmic strain -nu ln z across.
const std::vector<Law> laws{
    {"fem-hooke", [](double z, double) { return E * (z - 1); },
     [](double z, double nu) { return z * std::pow(1 - nu * (z - 1), 2); }},
    {"fem-stvk", [](double z, double) { return E * z * (z * z - 1) / 2; },
     [](double z, double nu) { return z * (1 - nu * (z * z - 1)); }},
    {"fem-hencky", [](double z, double) { return E * std::log(z) / z; },
     [](double z, double nu) { return std::pow(z, 1 - 2 * nu); }}};

}  // namespace

// Homogeneous fields are in every element's space. Forces are solved to 1e-10 of
// themselves; at nu = .49 the volume's stiffness multiplies what that leaves in lengths.
BOOST_AUTO_TEST_CASE(every_law_and_element_has_its_closed_form_in_uniaxial_stress,
                     *boost::unit_test::tolerance(1e-8)) {
  for (const Law& law : laws)
    for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"})
      for (const double nu : {0., 0.25, 0.49})
        for (const double strain : {-0.2, 0.2})
          BOOST_TEST_CONTEXT(law.method << ":" << element << ", nu " << nu << ", strain "
                                        << strain) {
            const Measures m =
                result_of("uniaxial",
                          {"method=" + law.method, std::string("element=") + element,
                           number("nu", nu), number("deformation", strain)})
                    .measures;
            const double z = 1 + strain;
            BOOST_TEST(m.force->z() == area * law.stress(z, nu));
            BOOST_TEST(*m.plate_force == area * std::abs(law.stress(z, nu)));
            BOOST_TEST(1 + *m.volume_change == law.volume_ratio(z, nu));
            BOOST_TEST(*m.cell_volume_ratio_min == *m.cell_volume_ratio_max);
          }
}

// Averages around nodes do not leave the homogeneous state of tetrahedra that are
// pressed, near nu = 1/2 either.
BOOST_AUTO_TEST_CASE(tetrahedra_averaged_around_nodes_stay_homogeneous,
                     *boost::unit_test::tolerance(1e-8)) {
  for (const Law& law : laws)
    for (const char* cells : {"tetrahedron", "free-tetrahedron"})
      for (const double nu : {0.25, 0.49})
        BOOST_TEST_CONTEXT(law.method << ", " << cells << ", nu " << nu) {
          const Measures m =
              result_of("uniaxial", {"method=" + law.method, "element=q1-nodal",
                                     std::string("cell-type=") + cells, number("nu", nu),
                                     number("deformation", -0.2)})
                  .measures;
          BOOST_TEST(m.force->z() == area * law.stress(0.8, nu));
          BOOST_TEST(1 + *m.volume_change == law.volume_ratio(0.8, nu));
        }
}

// Without plates that clamp it the lattice is its own continuum, whatever its springs.
// mss-nfd and mss-baudet wrinkle when pressed, and so are pulled here.
BOOST_AUTO_TEST_CASE(springs_are_the_continuum_that_cauchy_born_takes_them_for,
                     *boost::unit_test::tolerance(1e-8)) {
  for (const std::string springs : {"mss-baudet", "mss-nfd", "mss-fd", "mss-cf",
                                    "mss-stvk", "mss-hencky", "mss-affine-hencky"})
    for (const double nu : {0.1, 0.25, 0.45}) {
      const auto measured = [&](const std::string& method) {
        std::vector<std::string> changes{"method=" + method, "reference=fem-cauchy-born",
                                         "lattice=" + springs, "deformation=.2",
                                         number("nu", nu)};
        if (reads(*find_method(springs), "diagonal-ratio"))
          changes.emplace_back("diagonal-ratio=2");
        return result_of("uniaxial", changes).measures;
      };
      BOOST_TEST_CONTEXT(springs << ", nu " << nu) {
        const Measures lattice = measured(springs),
                       continuum = measured("fem-cauchy-born");
        BOOST_TEST(*lattice.plate_force == *continuum.plate_force);
        BOOST_TEST(*lattice.volume_change == *continuum.volume_change);
        BOOST_TEST(*lattice.strain_energy == *continuum.strain_energy);
      }
    }
}

// The stress over E strain is taken at -20 % along three directions of mss-cf's lattice.
// Scenes are solved to 1e-8 of the force.
BOOST_AUTO_TEST_CASE(lattice_is_not_isotropic_at_finite_strain,
                     *boost::unit_test::tolerance(1e-7)) {
  for (const std::string nu : {"0.25", "0.499"})
    for (const std::string direction : {"100", "110", "111"}) {
      const Measures m = result_of("uniaxial", {"method=fem-cauchy-born", "nu=" + nu,
                                                "lattice-direction=" + direction})
                             .measures;
      BOOST_TEST(*m.plate_force / (area * E * 0.2) ==
                 referee::figure("bars",
                                 "mss-cf nu " + nu + " along " + direction + " -0.2",
                                 "stress"));
    }
}

// The closed form's stress as a load gives the strain back; a mean displacement of the
// face is as good as the lengths above.
BOOST_AUTO_TEST_CASE(traction_on_a_sliding_body_is_the_inverse_of_uniaxial,
                     *boost::unit_test::tolerance(1e-8)) {
  for (const Law& law : laws)
    for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"})
      for (const double strain : {-0.1, 0.1}) {
        const double stress = law.stress(1 + strain, 0.3);
        const Measures m =
            result_of("traction",
                      {"method=" + law.method, "nu=.3", std::string("element=") + element,
                       "traction=0,0," + nlohmann::json(stress).dump()})
                .measures;
        BOOST_TEST_CONTEXT(law.method << ":" << element << ", strain " << strain) {
          BOOST_TEST(m.face_displacement->z() == 0.05 * strain);
          BOOST_TEST(1 + *m.volume_change == law.volume_ratio(1 + strain, 0.3));
          BOOST_TEST(m.force->z() == area * stress);
        }
      }
}

// The glued plate holds against the load, and nothing else does. The error is bounded by
// the residual, 1e-10 of the forces.
BOOST_AUTO_TEST_CASE(glued_plate_holds_against_any_traction) {
  for (const char* method : {"mss-cf", "fem-hooke", "fem-stvk", "fem-hencky"})
    for (const char* element : {"q1-sri", "q2"}) {
      const CaseResult result = result_of(
          "traction", {std::string("method=") + method, std::string("element=") + element,
                       "plates=glued", "traction=60,-30,100"});
      Vector3 held = Vector3::Zero();
      for (const Vector3& reaction : result.solution.reactions) held += reaction;
      BOOST_TEST(
          (held + *result.measures.force).norm() < 1e-9 * *result.measures.plate_force,
          method << ":" << element);
      BOOST_TEST((*result.measures.force - area * Vector3(60, -30, 100)).norm() < 1e-12);
    }
}

// Clapeyron's theorem: a dead traction's work, t.u A by the mean u of its face, is twice
// what a linear body stores. The error is bounded by the residual, 1e-10 of the forces.
BOOST_AUTO_TEST_CASE(work_of_a_traction_is_twice_hooke_s_energy,
                     *boost::unit_test::tolerance(1e-9)) {
  for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"}) {
    const Measures m =
        result_of("traction", {"method=fem-hooke", std::string("element=") + element,
                               "plates=glued", "traction=60,-30,100"})
            .measures;
    BOOST_TEST(m.force->dot(*m.face_displacement) == 2 * *m.strain_energy, element);
  }
}

// The patch test of springs and elements at a gradient of any size, and P = F S of
// St-Venant-Kirchhoff in closed form. The tolerance is round-off, times the condition of
// the tangent.
BOOST_AUTO_TEST_CASE(inside_follows_an_affine_boundary) {
  const std::string gradient = "gradient=.1,.04,-.03,.02,-.08,.05,-.01,.03,.06";
  for (const char* method : {"mss-baudet", "mss-fd", "mss-cf", "fem-hooke", "fem-stvk",
                             "fem-hencky", "fem-cauchy-born"})
    for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"}) {
      const Measures m =
          result_of("affine", {std::string("method=") + method,
                               std::string("element=") + element, gradient, "nu=.4"})
              .measures;
      BOOST_TEST(*m.affine_deviation_relative < 1e-12, method << ":" << element);
    }
}

BOOST_AUTO_TEST_CASE(mean_stress_is_that_of_the_law) {
  const std::string gradient = "gradient=.1,.04,-.03,.02,-.08,.05,-.01,.03,.06";
  for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"}) {
    const CaseResult result = result_of(
        "affine",
        {"method=fem-stvk", std::string("element=") + element, gradient, "nu=.4"});
    const Eigen::Matrix3d H = result.request.settings.gradient,
                          I = Eigen::Matrix3d::Identity(), F = I + H;
    const auto [lambda, mu] = lame_constants(result.request.settings.material);
    const Eigen::Matrix3d strain = (F.transpose() * F - I) / 2,
                          P = F * (lambda * strain.trace() * I + 2 * mu * strain);
    BOOST_TEST((*result.measures.mean_stress - P).norm() < 1e-10 * P.norm(), element);
  }
  // The springs' is their continuum's.
  const auto stress = [&](const char* method) {
    return *result_of("affine", {std::string("method=") + method, gradient, "nu=.4"})
                .measures.mean_stress;
  };
  const Eigen::Matrix3d lattice = stress("mss-cf");
  BOOST_TEST((lattice - stress("fem-cauchy-born")).norm() < 1e-10 * lattice.norm());
}

// The block of St-Venant-Kirchhoff becomes unstable at the same strain whatever strain it
// is driven to. The path brackets it by a last step of up to 2/1024 of the load.
BOOST_AUTO_TEST_CASE(loss_of_definiteness_does_not_depend_on_where_the_load_ends) {
  const auto lost_at = [](const char* deformation) {
    const CaseResult result = any_result_of(
        "uniaxial", {"method=fem-stvk", std::string("deformation=") + deformation});
    BOOST_TEST((result.status == Status::no_equilibrium), name_of(result.status));
    return result.measures.definite_up_to_deformation.value();
  };
  BOOST_TEST(std::abs(lost_at("-.35") - lost_at("-.45")) < 0.45 * 2 / 1024);
  BOOST_TEST(std::abs(lost_at("-.4") - lost_at("-.45")) < 0.45 * 2 / 1024);
  BOOST_TEST(!result_of("uniaxial", {"method=fem-stvk", "deformation=-.2"})
                  .measures.definite_up_to_deformation.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
