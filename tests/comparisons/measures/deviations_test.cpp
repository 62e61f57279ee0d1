#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/measures/measures.hpp"
#include "tests/comparisons/measures/solutions.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(deviations_test)

// One interior node is off by d, so that every measure has a closed form. The tolerance
// is round-off.
BOOST_AUTO_TEST_CASE(deviations_of_one_moved_node, *utf::tolerance(1e-12)) {
  const CaseSettings settings = small_block("compression");
  const Mesh mesh = build_mesh(settings.body);
  const auto nodes = static_cast<double>(mesh.nodes().size());
  Solution here = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); }),
           reference = here;
  const double d = 0.001;
  const auto middle =
      static_cast<std::size_t>(2 + 5 * (2 + 5 * 4));  // x = y = .2, z = .4
  here.displacements[middle] = Vector3(0, d, 0);
  Measures m;
  measure_deviation(m, settings, mesh, here, reference);
  BOOST_TEST(*m.mean_deviation == d / nodes);
  BOOST_TEST(*m.max_deviation == d);
  BOOST_TEST(*m.middle_layer_deviation == d / 25);
  // Free nodes stand for 7 of 8 layers, the interior one for a cell; the plate moves .08
  // m.
  const double free_volume = 0.4 * 0.4 * 0.7, own = 1e-3;
  BOOST_TEST(*m.deviation_l2_relative == d * std::sqrt(own / free_volume) / 0.08);
  BOOST_TEST(*m.deviation_max_relative == d / 0.08);
  // The eight cells of the node change volume by +-d times a quarter of a face, the
  // others do not change at all.
  BOOST_TEST(*m.cell_volume_ratio_rms_difference ==
             std::sqrt(8. / 128) * d * 0.1 * 0.1 / 4 / 1e-3);
}

// A corner of the plate, at r = .2 sqrt(2) m from the axis, is 2 r sin(angle/2) from its
// place, and after half a turn it has been 2 r away: a whole turn that ends where it
// began has no smaller measure. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(deviations_in_torsion_are_divided_by_the_largest_chord_of_the_way,
                     *utf::tolerance(1e-12)) {
  const double r = 0.2 * std::sqrt(2.), d = 0.001;
  for (const auto& [angle, chord] :
       {std::pair("60deg", r), std::pair("180deg", 2 * r), std::pair("270deg", 2 * r),
        std::pair("360deg", 2 * r)}) {
    const CaseSettings settings = small_block("torsion", angle);
    const Mesh mesh = build_mesh(settings.body);
    const Solution reference =
        moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
    Solution here = reference;
    here.displacements[static_cast<std::size_t>(2 + 5 * (2 + 5 * 4))].y() = d;  // inside
    Measures m;
    measure_deviation(m, settings, mesh, here, reference);
    BOOST_TEST(*m.deviation_max_relative == d / chord);
  }
}

BOOST_AUTO_TEST_CASE(odd_cell_counts_have_no_middle_layer_and_a_tip_between_nodes) {
  const CaseSettings odd = case_of("bending", {"cells=3,4,5", "method=mss-cf"});
  const Mesh mesh = build_mesh(odd.body);
  const Solution still = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
  Measures m = measure(odd, mesh, still);
  measure_deviation(m, odd, mesh, still, still);
  BOOST_TEST(m.tip_deflection.value() == 0);
  const Solution tilted = moved(mesh, [](const Vector3& x) {
    return Vector3(-x.x() - 2 * x.y(), 0, 0);  // the centre by .2 and .4 m
  });
  BOOST_TEST(measure(odd, mesh, tilted).tip_deflection.value() == 0.6,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(!m.middle_layer_deviation.has_value());
  BOOST_TEST(!m.deviation_l2_relative.has_value());
  BOOST_TEST(m.tip_elastica.has_value());
}

// On other meshes some nodes lie there by chance.
BOOST_AUTO_TEST_CASE(layers_and_lines_of_nodes_are_those_of_regular_grids) {
  for (const char* cells : {"cell-type=free-tetrahedron", "distortion=0.1"}) {
    const CaseSettings settings = case_of("bending", {"cells=2,2,12", cells});
    const Mesh mesh = build_mesh(settings.body);
    const Solution still = moved(mesh, [](const Vector3&) { return Vector3(0, 0, 0); });
    Measures m = measure(settings, mesh, still);
    measure_deviation(m, settings, mesh, still, still);
    BOOST_TEST(m.tip_elastica.has_value());
    BOOST_TEST(!m.centre_line_elastica.has_value(), cells);
    BOOST_TEST(!m.middle_layer_deviation.has_value(), cells);
  }
}

BOOST_AUTO_TEST_SUITE_END()
