#include "comparisons/measures/wrinkles.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/cases/mechanical_scene.hpp"
#include "tests/comparisons/measures/solutions.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(wrinkles_test)

// The body is pressed by a tenth, so that the sides' strain is (1/2)(.9^2 - 1) along z.
// The tolerance is round-off.
BOOST_AUTO_TEST_CASE(a_zigzag_is_wrinkled_and_a_bulge_is_not, *utf::tolerance(1e-9)) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  const Scene scene = mechanical_scene(settings, mesh);
  const auto wrinkling = [&](auto&& field) {
    return measure_wrinkling(
               mesh, scene,
               moved(mesh,
                     [&](const Vector3& x) {
                       return Vector3(Vector3(0, 0, -0.1 * x.z()) + field(x));
                     })
                   .displacements)
        .value();
  };
  // The zigzag goes from node to node along z: neighbours across are alike, so that r is
  // the height a; of 7 nodes in a line 6 pairs alternate.
  const double a = 0.001, strain = (1 - 0.9 * 0.9) / 2;
  const auto zigzag = [](double height) {
    return [height](const Vector3& x) {
      return Vector3(std::lround(x.z() / 0.1) % 2 == 0 ? height : -height, 0, 0);
    };
  };
  const Wrinkling seen = wrinkling(zigzag(a));
  BOOST_TEST(seen.alternation.value() == 6. / 7);
  BOOST_TEST(seen.amplitude == a / (0.1 * strain));
  BOOST_TEST(!is_wrinkled(wrinkling(zigzag(0.11 * 0.1 * strain))));
  BOOST_TEST(is_wrinkled(wrinkling(zigzag(0.13 * 0.1 * strain))));
  const Wrinkling bulge = wrinkling([](const Vector3& x) {
    return Vector3((x.x() - 0.2) * x.z() * (0.8 - x.z()), 0, 0);
  });
  BOOST_TEST(bulge.alternation.value() < 1e-9);
  BOOST_TEST(!is_wrinkled(bulge));
}

// Turned by 70 degrees, sheared and stretched: u is affine, so that r is round-off, on
// triangles of any shape too. At rest there is no strain to compare with.
BOOST_AUTO_TEST_CASE(homogeneous_deformations_and_rest_are_not_wrinkled) {
  Eigen::Matrix3d F = Eigen::AngleAxisd(1.2, Vector3(1, 2, 3).normalized()).matrix();
  F.col(0) *= 1.3;
  F.col(1) += 0.2 * F.col(2);
  for (const char* cells : {"hexahedron", "tetrahedron", "free-tetrahedron", "mixed"}) {
    const CaseSettings settings =
        case_of("compression",
                {"cells=4,4,4", std::string("cell-type=") + cells, "method=mss-affine"});
    const Mesh mesh = build_mesh(settings.body);
    const auto seen = [&](const Eigen::Matrix3d& gradient) {
      return measure_wrinkling(
                 mesh, mechanical_scene(settings, mesh),
                 moved(mesh, [&](const Vector3& x) { return Vector3(gradient * x); })
                     .displacements)
          .value();
    };
    BOOST_TEST(seen(F - Eigen::Matrix3d::Identity()).amplitude < 1e-12, cells);
    BOOST_TEST(!seen(F - Eigen::Matrix3d::Identity()).alternation, cells);
    BOOST_TEST(!is_wrinkled(seen(F - Eigen::Matrix3d::Identity())), cells);
    BOOST_TEST(seen(Eigen::Matrix3d::Zero()).amplitude == 0, cells);
  }
}

// Two nodes in a line of opposite r alternate by 1/2, and by rounding above it.
BOOST_AUTO_TEST_CASE(three_cells_are_never_wrinkled) {
  const Wrinkling s_shape{.alternation = 0.5000000001, .amplitude = 1};
  BOOST_TEST(!is_wrinkled(s_shape));
  const CaseSettings settings =
      case_of("compression", {"size=.3,.3,.3", "cells=3,3,3", "method=mss-cf"});
  const Mesh mesh = build_mesh(settings.body);
  const Wrinkling seen =
      measure_wrinkling(mesh, mechanical_scene(settings, mesh),
                        moved(mesh,
                              [](const Vector3& x) {
                                const double sign =
                                    std::lround(x.z() / 0.1) % 2 == 0 ? 1 : -1;
                                return Vector3(0.01 * sign, 0.01 * sign, -0.1 * x.z());
                              })
                            .displacements)
          .value();
  BOOST_TEST(std::abs(seen.alternation.value() - 0.5) < 1e-9);
  BOOST_TEST(!is_wrinkled(seen));
}

BOOST_AUTO_TEST_CASE(plates_are_not_searched_for_wrinkles) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  const auto zigzag = moved(mesh, [](const Vector3& x) {
    const bool is_on_plate = x.z() < 0.01 || x.z() > 0.79;
    const double height = std::lround(x.x() / 0.1) % 2 == 0 ? 0.005 : -0.005;
    return Vector3(0, 0, -0.1 * x.z() + (is_on_plate ? height : 0));
  });
  BOOST_TEST(!is_wrinkled(
      measure_wrinkling(mesh, mechanical_scene(settings, mesh), zigzag.displacements)
          .value()));
}

// A sliding plate is a plate like a glued one; the face that a traction loads is free; an
// affine boundary leaves no face.
BOOST_AUTO_TEST_CASE(faces_without_a_plate_are_searched_for_wrinkles) {
  const auto seen = [](const CaseSettings& settings, const std::string& face) {
    const Mesh mesh = build_mesh(settings.body);
    Solution solution =
        moved(mesh, [](const Vector3& x) { return Vector3(0, 0, -0.1 * x.z()); });
    for (const NodeIndex n : mesh.region(face).nodes)
      solution.displacements[n].z() +=
          std::lround(mesh.nodes()[n].x() / 0.1) % 2 == 0 ? 0.005 : -0.005;
    return measure_wrinkling(mesh, mechanical_scene(settings, mesh),
                             solution.displacements);
  };
  const CaseSettings traction =
      case_of("traction", {"size=.4,.4,.8", "cells=4,4,8", "method=mss-cf"});
  BOOST_TEST(is_wrinkled(seen(traction, "top").value()));
  BOOST_TEST(!is_wrinkled(seen(traction, "bottom").value()));
  BOOST_TEST(!is_wrinkled(seen(small_block("uniaxial"), "top").value()));
  BOOST_TEST(!is_wrinkled(seen(small_block("uniaxial"), "bottom").value()));
  const CaseSettings affine =
      case_of("affine", {"size=.4,.4,.8", "cells=4,4,8", "method=mss-cf"});
  BOOST_TEST(!seen(affine, "top").has_value());
}

BOOST_AUTO_TEST_SUITE_END()
