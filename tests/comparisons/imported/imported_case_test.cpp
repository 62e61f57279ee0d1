#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/commands/output/result_json.hpp"
#include "comparisons/imported/imported_case.hpp"
#include "comparisons/imported/nodal_csv.hpp"
#include "comparisons/results/result_file.hpp"
#include "tests/comparisons/imported/messages.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(imported_case_test)

namespace {

constexpr auto silent = [](std::size_t, std::size_t) {};

CaseResult measured(const RunSettings& run, const ImportedFields& fields,
                    MeshStore& meshes) {
  return imported_case(run, "mine", fields, meshes, silent);
}

/// What a run of one method computed.
ImportedFields fields_of(const CaseResult& result) {
  return {.displacements = result.solution.displacements,
          .forces = result.solution.reactions};
}

std::vector<Vector3> affine_field(const Mesh& mesh, const Eigen::Matrix3d& gradient) {
  std::vector<Vector3> u;
  for (const Vector3& x : mesh.nodes()) u.push_back(gradient * x);
  return u;
}

}  // namespace

// In every test of the plates, beams, tractions and affine boundaries, what a method of
// ours computed has the same measures when another program computed it. The same
// arithmetic works on the same numbers, so they agree bit by bit; the reference is
// deterministic.
BOOST_AUTO_TEST_CASE(a_field_of_our_own_has_the_measures_it_had) {
  for (const char* scene : {"compression", "tension", "shearing", "torsion", "bending",
                            "uniaxial", "traction", "affine"}) {
    std::vector<std::string> changes{"method=mss-cf"};
    if (std::string(scene) == "compression") changes.emplace_back("cells=4,4,4");
    const RunSettings run = run_of(scene, changes);
    MeshStore meshes;
    const CaseResult ours = run_study(requests(run), meshes, 1, silent).front();
    BOOST_TEST_REQUIRE((ours.status == Status::ok), scene);
    const CaseResult theirs = measured(run, fields_of(ours), meshes);
    BOOST_TEST((theirs.status == ours.status), scene);
    BOOST_TEST(!theirs.measures.strain_energy.has_value());
    Measures without_energy = ours.measures;
    without_energy.strain_energy.reset();
    without_energy.definite_up_to_deformation.reset();
    without_energy.wall_s.reset();
    without_energy.solve_wall_s.reset();
    std::vector<std::string> mine, other;
    const auto collect = [](std::vector<std::string>& into) {
      return [&](const Measure& measure, const auto& value) {
        std::ostringstream text;
        text.precision(17);
        if (value) text << *value;
        into.push_back(std::string(measure.name) + " " + text.str());
      };
    };
    for_each_measure(without_energy, collect(mine));
    for_each_measure(theirs.measures, collect(other));
    BOOST_TEST(mine == other, boost::test_tools::per_element());
    BOOST_TEST(theirs.reason == ours.reason);
  }
}

// A limit is no state at the load: no reference by it. Static elements are one.
BOOST_AUTO_TEST_CASE(a_field_is_never_compared_with_a_limit) {
  for (const auto& [reference, is_compared] :
       {std::pair{"mss-cf", false}, std::pair{"fem-stvk", true}}) {
    const RunSettings run =
        run_of("compression", {"method=mss-cf", "cells=2,2,2", "solver=limit",
                               std::string("reference=") + reference});
    MeshStore meshes;
    const Mesh& mesh = meshes.mesh(run.common.body);
    const ImportedFields fields{
        .displacements = affine_field(mesh, Eigen::Matrix3d::Zero()), .forces = {}};
    const CaseResult found = measured(run, fields, meshes);
    BOOST_TEST(found.request.reference.has_value() == is_compared, reference);
    BOOST_TEST(found.measures.mean_deviation.has_value() == is_compared, reference);
  }
}

BOOST_AUTO_TEST_CASE(the_same_field_through_a_csv_file_is_the_same_case) {
  const OwnFolder own;
  const RunSettings run = run_of("shearing", {"method=mss-cf", "cells=3,3,3"});
  MeshStore meshes;
  const CaseResult ours = run_study(requests(run), meshes, 1, silent).front();
  const ImportedFields fields = fields_of(ours);
  std::ostringstream u, f;
  u.precision(17);
  f.precision(17);
  u << "node,ux,uy,uz\n";
  f << "node,fx,fy,fz\n";
  const Eigen::IOFormat row(17, Eigen::DontAlignCols, ",", ",");
  for (std::size_t n = 0; n < fields.displacements.size(); ++n) {
    u << n + 1 << "," << fields.displacements[n].transpose().format(row) << "\n";
    if (!fields.forces[n].isZero(0))
      f << n + 1 << "," << fields.forces[n].transpose().format(row) << "\n";
  }
  write(own.path / "u.csv", u.str());
  write(own.path / "f.csv", f.str());
  const Mesh& mesh = meshes.mesh(run.common.body);
  const ImportedFields read{
      .displacements =
          read_nodal_csv(own.path / "u.csv", mesh, NodalQuantity::displacement),
      .forces = read_nodal_csv(own.path / "f.csv", mesh, NodalQuantity::force)};
  BOOST_TEST((read.displacements == fields.displacements));
  BOOST_TEST(measured(run, read, meshes).key == measured(run, fields, meshes).key);
}

// u = H X in the affine scene: V/V0 = det(I + H), and nothing is off the field.
BOOST_AUTO_TEST_CASE(a_homogeneous_field_has_the_measures_of_paper) {
  const RunSettings run = run_of("affine", {"gradient=.1,.02,0,0,-.05,.01,0,0,.03"});
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  const Eigen::Matrix3d& H = run.common.gradient;
  const CaseResult result =
      measured(run, {.displacements = affine_field(mesh, H), .forces = {}}, meshes);
  const double ratio = (Eigen::Matrix3d::Identity() + H).determinant();
  const auto round_off = boost::test_tools::tolerance(1e-12);
  BOOST_TEST((result.status == Status::ok));
  BOOST_TEST(result.measures.volume_change.value() == ratio - 1, round_off);
  BOOST_TEST(result.measures.cell_volume_ratio_max.value() == ratio, round_off);
  BOOST_TEST(result.measures.affine_deviation_relative.value() < 1e-12);
  BOOST_TEST(result.measures.deviation_l2_relative.value() < 1e-9);  // of the reference
  BOOST_TEST(!result.measures.mean_stress.has_value());  // no forces were given
}

BOOST_AUTO_TEST_CASE(detectors_judge_the_field) {
  const RunSettings run = run_of("compression", {"method=mss-cf", "cells=6,6,6"});
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  const double h = run.common.body.block.size[0] / 6;
  std::vector<Vector3> u =
      affine_field(mesh, Vector3(0, 0, -*run.common.deformation).asDiagonal());
  const auto status = [&](const std::vector<Vector3>& field) {
    return name_of(measured(run, {.displacements = field, .forces = {}}, meshes).status);
  };
  BOOST_TEST(status(u) == "ok");
  // The free faces have a zigzag at x = 0 of one cell's period along z, h/10 high.
  std::vector<Vector3> zigzag = u, inside_out = u;
  for (NodeIndex n = 0; n < mesh.nodes().size(); ++n) {
    const Vector3& x = mesh.nodes()[n];
    const auto level = std::lround(x.z() / h);
    const bool is_inside = level > 0 && level < 6;
    if (is_inside && x.x() < h / 2) zigzag[n].x() += (level % 2 == 0 ? h : -h) / 10;
    // One node inside is pulled through the cells beside it.
    if ((x - Vector3::Constant(3 * h)).norm() < h / 2) inside_out[n].x() += 1.5 * h;
  }
  BOOST_TEST(status(zigzag) == "wrinkled");
  BOOST_TEST(status(inside_out) == "inverted");
}

BOOST_AUTO_TEST_CASE(what_contradicts_the_scene_is_said_and_not_refused) {
  const RunSettings run = run_of("compression", {"method=mss-cf", "cells=2,2,2"});
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  ImportedFields fields{
      .displacements =
          affine_field(mesh, Vector3(0, 0, -*run.common.deformation).asDiagonal()),
      .forces = std::vector<Vector3>(mesh.nodes().size(), Vector3::Zero())};
  fields.forces[26] = Vector3(0, 0, -1);  // on the upper plate
  const auto reason = [&] { return measured(run, fields, meshes).reason; };
  BOOST_TEST(reason() == "");
  fields.forces[13] = Vector3(0, 1e-7, 0);  // round-off on the node in the middle
  BOOST_TEST(reason() == "");
  fields.forces[13] = Vector3(0, 0.25, 0);
  BOOST_TEST(reason() ==
             "forces act where the scene has no support: 0.25 N on node 14, the largest");
  fields.forces.clear();
  fields.displacements[0].x() += 0.002;
  fields.displacements[26].y() -= 0.003;
  BOOST_TEST(reason() ==
             "displacements do not follow the scene's supports: node 27 is 0.003 m off, "
             "the farthest");
}

// Cells' volumes overflow above 1e102 m, squares of distances above 1e154 m.
BOOST_AUTO_TEST_CASE(numbers_that_overflow_are_refused) {
  const RunSettings run = run_of("uniaxial", {"cells=2,2,2", "method=mss-cf"});
  MeshStore meshes;
  const std::size_t nodes = meshes.mesh(run.common.body).nodes().size();
  const auto refusal = [&](const Vector3& shift, double stretch) {
    ImportedFields fields{.displacements = std::vector<Vector3>(nodes, shift),
                          .forces = {}};
    fields.displacements.back() *= stretch;
    return message_of("", [&] { measured(run, fields, meshes); });
  };
  BOOST_TEST(refusal(Vector3(0.1, 0, 0), 1) == "accepted");
  for (const double stretch : {1., -1e10})
    for (const Vector3& shift : {Vector3(0, 1e200, 0), Vector3(1e300, 1e300, 1e300)})
      BOOST_TEST(refusal(shift, stretch)
                     .starts_with("--displacements: expected numbers that can be "
                                  "measured, got "));
}

BOOST_AUTO_TEST_CASE(the_key_follows_the_numbers) {
  const RunSettings run = run_of("uniaxial", {"cells=2,2,2", "method=mss-cf"});
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  ImportedFields fields{
      .displacements = std::vector<Vector3>(mesh.nodes().size(), Vector3::Zero()),
      .forces = {}};
  const auto key = [&] { return measured(run, fields, meshes).key; };
  const std::string first = key();
  BOOST_TEST(key() == first);
  fields.displacements[3].x() = -0.;
  BOOST_TEST(key() == first);
  fields.displacements[3].x() = 1e-12;
  const std::string moved = key();
  BOOST_TEST(moved != first);
  fields.forces = std::vector<Vector3>(mesh.nodes().size(), Vector3::Zero());
  BOOST_TEST(key() != moved);
}

BOOST_AUTO_TEST_CASE(an_imported_case_is_stored_without_what_only_solvers_know) {
  const OwnFolder own;
  const auto file = own.path / "mine.h5";
  const RunSettings run = run_of("compression", {"method=mss-cf", "cells=3,3,3"});
  MeshStore meshes;
  const auto ours = run_study(requests(run), meshes, 1, silent);
  ImportedFields fields = fields_of(ours.front());
  fields.forces.clear();
  const CaseResult result = measured(run, fields, meshes);
  write_results(file, std::vector{ours.front(), result}, meshes);

  const auto stored = read_results(file, Revisions::own);
  BOOST_TEST(stored.at(ours.front().key).effort.has_value());
  BOOST_TEST(!stored.at(result.key).effort.has_value());
  CaseResult read = with_stored(result.request, stored.at(result.key));
  read_fields(file, meshes.mesh(run.common.body), read);
  BOOST_TEST((read.solution.displacements == fields.displacements));
  BOOST_TEST(read.solution.reactions.empty());
  BOOST_TEST((read.measures.mean_deviation == result.measures.mean_deviation));
  BOOST_TEST((read.deviation == ours.front().deviation));
  BOOST_TEST(!read.measures.plate_force.has_value());

  const auto json =
      run_json("compression", {result}, {std::nullopt}, meshes)["results"][0];
  BOOST_TEST(json["method"] == "mine");
  BOOST_TEST(json["source"] == "measured");
  for (const char* key :
       {"solver", "element", "plate_force", "force", "torque", "steps", "load_fraction",
        "force_evaluations", "strain_energy", "wall_s", "solve_wall_s", "dt"})
    BOOST_TEST(json[key].is_null(), key);
}

BOOST_AUTO_TEST_CASE(labels_are_names_of_one_s_own) {
  const auto refusal = [](const std::string& label) {
    return message_of("", [&] { imported_method(label, {}); });
  };
  BOOST_TEST(refusal("Müller's springs (2024)") == "accepted");
  for (const char* label :
       {"", "  ", "mss-cf", "fem-hencky", "a,b", "a\nb", "\x7F", "\xFF"})
    BOOST_TEST(refusal(label).starts_with("--label: expected "), label);
}

BOOST_AUTO_TEST_SUITE_END()
