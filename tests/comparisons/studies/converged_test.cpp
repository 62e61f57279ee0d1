#include <boost/test/unit_test.hpp>

#include "comparisons/cases/grids.hpp"
#include "comparisons/studies/converged.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(converged_test)

namespace {

CaseResult result_of(const std::string& scene, const std::vector<std::string>& changes,
                     MeshStore& meshes) {
  return run_study(requests(run_of(scene, changes)), meshes, 1,
                   [](std::size_t, std::size_t) {})
      .front();
}

}  // namespace

// A homogeneous field is the same on every grid. The solver leaves about 1e-10 of it.
BOOST_AUTO_TEST_CASE(a_homogeneous_field_does_not_deviate_from_finer_grids) {
  MeshStore meshes;
  for (const char* reference :
       {"fem-stvk@4", "fem-stvk:q2@6,2,4", "fem-stvk@converged"}) {
    const CaseResult result = result_of(
        "affine",
        {"cells=2,2,2", "method=fem-stvk", std::string("reference=") + reference},
        meshes);
    const Measures& m = result.measures;
    BOOST_TEST_CONTEXT(reference) {
      BOOST_TEST_REQUIRE(m.deviation_l2_relative.has_value());
      BOOST_TEST(*m.deviation_l2_relative < 1e-8);
      BOOST_TEST(*m.deviation_max_relative < 1e-8);
      BOOST_TEST(*m.cell_volume_ratio_rms_difference < 1e-10);
    }
  }
}

// All nodes of a single layer of cubes are held: their changes tell no order, and those
// inside the finer grids do change. Was 0.
BOOST_AUTO_TEST_CASE(a_coarsest_grid_of_held_nodes_leaves_an_error_bound) {
  MeshStore meshes;
  const CaseResult result = result_of(
      "compression",
      {"size=0.1,0.1,0.05", "cells=2,2,1", "cell-type=pyramid", "method=mss-affine",
       "deformation=1e-5", "reference=fem-hooke@converged"},
      meshes);
  BOOST_TEST(!result.measures.reference_order.has_value());
  BOOST_TEST(result.measures.reference_bar_l2_relative.value() > 1e-3);
}

// Deviations from a finer grid are the distance at the shared nodes and the volumes of
// the eight fine cells in each coarse one, taken by hand. They are exact: the simulations
// are the same.
BOOST_AUTO_TEST_CASE(deviations_from_a_finer_grid_are_taken_at_the_shared_nodes) {
  MeshStore meshes;
  const std::vector<std::string> changes{"method=fem-hencky", "deformation=.1"};
  const auto with = [&](const char* change) {
    auto all = changes;
    all.emplace_back(change);
    return all;
  };
  const CaseResult fine = result_of("shearing", with("cells=4,4,4"), meshes);
  auto on_coarse = with("cells=2,2,2");
  on_coarse.emplace_back("reference=fem-hencky@4");
  const CaseResult coarse = result_of("shearing", on_coarse, meshes);
  BOOST_TEST(reference_label(coarse.request) == "fem-hencky:q1-sri@4,4,4");

  const Cells two{2, 2, 2}, four{4, 4, 4};
  const auto u =
      interpolated(fine.solution.displacements, fine.request.settings.body.block,
                   meshes.mesh(coarse.request.settings.body).nodes());
  double sum = 0;
  for (std::size_t n = 0; n < u.size(); ++n)
    sum += (coarse.solution.displacements[n] - u[n]).norm();
  BOOST_TEST(*coarse.measures.mean_deviation == sum / 27, tolerance(1e-12));
  BOOST_TEST(*coarse.measures.mean_deviation > 1e-6);  // m: there is something to find

  const Mesh& fine_mesh = meshes.mesh(fine.request.settings.body);
  const Mesh& mesh = meshes.mesh(coarse.request.settings.body);
  const auto volumes = deformed_volumes(mesh, coarse.solution);
  const auto reference =
      summed_over_coarse_cells(deformed_volumes(fine_mesh, fine.solution), four, two);
  double squares = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    squares += std::pow((volumes[c] - reference[c]) / mesh.cell_volumes()[c], 2) / 8;
  BOOST_TEST(*coarse.measures.cell_volume_ratio_rms_difference == std::sqrt(squares),
             tolerance(1e-12));
}

// The case is on cells that the coarsest grid does not refine. On the finest grid's own
// cells it is the reference itself, which is known no better for that: less well than at
// the coarsest grid's nodes, which are farther from the plates' edges. Between the finest
// grid's nodes the error bound of interpolation joins it, and covers what is seen there.
BOOST_AUTO_TEST_CASE(on_other_cells_the_finest_grid_is_the_reference,
                     *boost::unit_test::label("slow")) {
  MeshStore meshes;
  const CaseSettings coarsest =
      requests(run_of("compression", {"method=fem-hencky", "deformation=.1",
                                      "cells=2,2,2", "element=q2"}))
          .front()
          .settings;
  const auto measures_on = [&](int across) {
    Request request{.settings = coarsest,
                    .reference = coarsest,
                    .reference_grid = ReferenceGrid::converged};
    request.settings.body.block.cells = {across, across, across};
    return run_study({request}, meshes, 1, [](std::size_t, std::size_t) {})
        .front()
        .measures;
  };
  const Measures on_2 = measures_on(2), on_6 = measures_on(6), on_8 = measures_on(8);
  for (const Measures& m : {on_2, on_6, on_8})
    BOOST_TEST_MESSAGE("deviation " << *m.deviation_l2_relative << ", error bound "
                                    << *m.reference_bar_l2_relative);
  BOOST_TEST(*on_8.deviation_l2_relative < 1e-12);
  BOOST_TEST(on_8.reference_order.value() == on_2.reference_order.value());
  BOOST_TEST(*on_8.reference_bar_l2_relative > *on_2.reference_bar_l2_relative);
  BOOST_TEST(*on_8.reference_bar_l2_relative < *on_2.reference_bar_l2_relative * 20);
  BOOST_TEST(*on_6.reference_bar_l2_relative > 2 * *on_8.reference_bar_l2_relative);
  // q2 on 6 cells is hardly farther from the limit than on 8: most of its deviation is
  // what lies between the reference's nodes.
  BOOST_TEST(*on_6.deviation_l2_relative < *on_2.deviation_l2_relative);
  BOOST_TEST(*on_6.deviation_l2_relative < 2 * *on_6.reference_bar_l2_relative);
}

// Under a traction deviations are divided by the reference's own face displacement, not
// by one read off at the coarse nodes. With three grids they are divided by what it
// converges to: beyond the finest grid's, by less than the last change. They are exact:
// the simulations are the same.
BOOST_AUTO_TEST_CASE(deviations_are_divided_by_the_reference_s_own_face_displacement) {
  MeshStore meshes;
  const std::vector<std::string> changes{"method=fem-hooke", "plates=glued",
                                         "traction=60,0,0"};
  const auto with = [&](const std::vector<std::string>& more) {
    auto all = changes;
    all.insert(all.end(), more.begin(), more.end());
    return result_of("traction", all, meshes).measures;
  };
  const auto divisor = [](const Measures& m) {
    return *m.max_deviation / *m.deviation_max_relative;
  };
  for (const std::string element : {"q1", "q2"}) {
    const double own =
        with({"element=" + element, "cells=4,4,4"}).face_displacement->norm();
    const Measures m = with({"cells=2,2,2", "reference=fem-hooke:" + element + "@4"});
    BOOST_TEST(divisor(m) == own, tolerance(1e-12));
  }
  const double on_4 = with({"cells=4,4,4"}).face_displacement->norm(),
               on_8 = with({"cells=8,8,8"}).face_displacement->norm();
  const double limit = divisor(with({"cells=2,2,2", "reference=fem-hooke@converged"}));
  BOOST_TEST(limit > on_8);
  BOOST_TEST(limit < on_8 + (on_8 - on_4));
}

// The error of a coarse solution is mostly gone on the next grid, and the converged field
// is further away than that: by the error bound the extrapolation gives.
BOOST_AUTO_TEST_CASE(the_converged_field_lies_beyond_the_finer_grids) {
  MeshStore meshes;
  const auto deviation_from = [&](const char* reference) {
    return *result_of("shearing",
                      {"cells=2,2,2", "method=fem-hencky",
                       std::string("reference=") + reference},
                      meshes)
                .measures.mean_deviation;
  };
  const double from_4 = deviation_from("fem-hencky@4"),
               from_8 = deviation_from("fem-hencky@8"),
               from_limit = deviation_from("fem-hencky@converged");
  BOOST_TEST(from_4 < from_8);
  BOOST_TEST(from_8 < from_limit);
  BOOST_TEST(from_limit < 1.5 * from_8);
}

// What a converged reference is worth goes with the deviations from it.
BOOST_AUTO_TEST_CASE(measures_hold_order_and_bar_of_an_extrapolated_reference) {
  MeshStore meshes;
  const auto measures_with = [&](const char* reference) {
    return result_of("shearing",
                     {"cells=2,2,2", "method=fem-hencky",
                      std::string("reference=") + reference},
                     meshes)
        .measures;
  };
  BOOST_TEST(!measures_with("fem-hencky@4").reference_bar.has_value());
  const Measures extrapolated = measures_with("fem-hencky@converged");
  std::vector<CaseResult> runs;
  for (const char* cells : {"cells=2,2,2", "cells=4,4,4", "cells=8,8,8"})
    runs.push_back(result_of("shearing", {cells, "method=fem-hencky"}, meshes));
  const std::array<const CaseResult*, 3> grids{&runs[0], &runs[1], &runs[2]};
  const ConvergedField field =
      converged_field(grids, runs[0].request.settings.body, meshes);
  BOOST_TEST(*extrapolated.reference_bar == field.error_bound);
  BOOST_TEST(*extrapolated.reference_order == *field.order);
  BOOST_TEST(field.error_bound > 0);
}

BOOST_AUTO_TEST_CASE(the_key_and_the_label_name_the_grid_of_the_reference) {
  MeshStore meshes;
  std::vector<std::string> keys, labels;
  for (const char* reference :
       {"fem-stvk", "fem-stvk@2", "fem-stvk@4", "fem-stvk@4,2,2", "fem-stvk@converged"}) {
    const Request request =
        requests(run_of("compression", {"cells=2,2,2", "method=mss-cf",
                                        std::string("reference=") + reference}))
            .front();
    keys.push_back(case_key(request, meshes.mesh(request.settings.body)));
    labels.push_back(reference_label(request));
  }
  BOOST_TEST(keys[0] == keys[1]);  // its own mesh, however it is said
  for (std::size_t i = 1; i < keys.size(); ++i)
    for (std::size_t j = i + 1; j < keys.size(); ++j) BOOST_TEST(keys[i] != keys[j]);
  const std::vector<std::string> expected{
      "fem-stvk:q1-sri", "fem-stvk:q1-sri", "fem-stvk:q1-sri@4,4,4",
      "fem-stvk:q1-sri@4,2,2", "fem-stvk:q1-sri@converged"};
  BOOST_TEST(labels == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(cells_of_a_reference_must_refine_the_case_s) {
  const auto refusal_of = [](const std::string& reference) -> std::string {
    try {
      requests(run_of("tension", {"method=mss-cf", "reference=" + reference}));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  BOOST_TEST(refusal_of("fem-stvk@8") == "accepted");  // 8, 8, 48
  BOOST_TEST(refusal_of("fem-stvk:q2@4,8,24") == "accepted");
  BOOST_TEST(refusal_of("fem-stvk@6") ==
             "--reference: cells of the reference: expected a whole multiple of the "
             "first of the case's 4,4,24, got 6");
  BOOST_TEST(refusal_of("fem-stvk@8,8,24,1").starts_with("--reference: expected "));
  BOOST_TEST(refusal_of("fem-stvk@8,6,24") ==
             "--reference: cells of the reference: expected whole multiples of the "
             "case's 4,4,24, got 8,6,24");
  for (const char* grid : {"@", "@0", "@-4", "@8,8", "@fine", "@8,", "@8x"})
    BOOST_TEST(
        refusal_of(std::string("fem-stvk") + grid).find("@NX,NY,NZ, @N or @converged") !=
            std::string::npos,
        grid);
  BOOST_TEST(refusal_of("fem-stvk@Converged").find("did you mean 'converged'?") !=
             std::string::npos);
}

// A reference that fails leaves no deviations, as one on the same mesh does.
BOOST_AUTO_TEST_CASE(a_reference_that_fails_leaves_no_deviations) {
  MeshStore meshes;
  const CaseResult result =
      result_of("compression",
                {"cells=2,2,2", "method=mss-cf", "nu=-0.3", "lattice=mss-baudet",
                 "reference=fem-cauchy-born@converged"},
                meshes);
  BOOST_TEST(result.measures.volume_error.has_value());
  BOOST_TEST(!result.measures.mean_deviation.has_value());
  BOOST_TEST(result.reason.starts_with("no deviation, the reference "
                                       "fem-cauchy-born:q1-sri@converged is refused: "),
             result.reason);
}

BOOST_AUTO_TEST_SUITE_END()
