#include "tests/cli/program.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

BOOST_AUTO_TEST_SUITE(measure_cli_test)

// The way of another program: nodes from the mesh file, a field by a formula, its
// measures. Hencky's law in uniaxial stress, stretch l = .9 along z: the sides stretch by
// l^-nu, V/V0 = l^(1 - 2 nu), and the plate presses with E ln(l)/l per undeformed area.
BOOST_AUTO_TEST_CASE(another_program_s_result_is_measured_on_the_mesh_it_was_given) {
  BOOST_TEST(run_springcheck("mesh uniaxial --out cube.inp").status == 0);
  std::istringstream mesh(text_of(folder / "cube.inp"));
  const double l = 0.9, across = std::pow(l, -0.25),
               force = 1e4 * std::log(l) / l * 25e-4;
  std::ofstream u(folder / "u.csv"), f(folder / "f.csv"), moved(folder / "moved.csv");
  for (std::ofstream* file : {&u, &f, &moved}) file->precision(17);
  u << "node,ux,uy,uz\n";
  moved << "x,y,z,ux,uy,uz\n";
  f << "node,fx,fy,fz\n";
  std::string line;
  while (std::getline(mesh, line) && !line.starts_with("*NODE")) continue;
  while (std::getline(mesh, line) && !line.starts_with("*")) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    int node = 0;
    double x = 0, y = 0, z = 0;
    numbers >> node >> x >> y >> z;
    u << node << "," << (across - 1) * x << "," << (across - 1) * y << "," << (l - 1) * z
      << "\n";
    moved << x << "," << y << "," << z << ",0,0," << (l - 1) * z << "\n";
    if (z == 0.05) f << node << ",0,0," << force / 25 << "\n";
  }
  for (std::ofstream* file : {&u, &f, &moved}) file->close();

  const std::string measure =
      "measure uniaxial --deformation -10% --reference fem-hencky --label theirs ";
  const Json theirs = json_of(measure +
                              "--displacements u.csv --forces f.csv --out own.h5 "
                              "--json")["results"][0];
  const auto round_off = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(theirs["method"] == "theirs");
  BOOST_TEST(theirs["source"] == "measured");
  BOOST_TEST(theirs["status"] == "ok");
  BOOST_TEST(theirs["reason"].is_null());
  BOOST_TEST(theirs["volume_change"].get<double>() == std::sqrt(l) - 1, round_off);
  BOOST_TEST(theirs["plate_force"].get<double>() == -force, round_off);
  BOOST_TEST(theirs["deviation_l2_relative"].get<double>() < 1e-9);  // Newton's residual
  for (const char* unknown : {"element", "solver", "steps", "load_fraction", "wall_s",
                              "force_evaluations", "strain_energy"})
    BOOST_TEST(theirs[unknown].is_null(), unknown);

  const Run bare = run_springcheck(measure + "--displacements moved.csv --json");
  const Json without_forces = Json::parse(bare.out)["results"][0];
  BOOST_TEST(bare.err.empty(), bare.err);
  BOOST_TEST(without_forces["plate_force"].is_null());
  BOOST_TEST(without_forces["volume_change"].get<double>() == l - 1, round_off);

  // A case beside others: the file is read again, and may take more.
  BOOST_TEST(run_springcheck("run uniaxial --method mss-cf --out own.h5").status == 0);
  BOOST_TEST(text_of(folder / "own.xdmf").find("uniaxial theirs nu=0.25") !=
             std::string::npos);

  // Pulled instead of pressed: said on stderr and beside the measures.
  const Run other = run_springcheck(
      "measure uniaxial --deformation 10% --displacements u.csv --label theirs --json");
  BOOST_TEST(other.status == 0);
  BOOST_TEST(other.err.find("is 0.01 m off") != std::string::npos, other.err);
  BOOST_TEST(Json::parse(other.out)["results"][0]["reason"].get<std::string>().find(
                 "do not follow the scene's supports") != std::string::npos);

  expect_bad_input(measure + "--displacements none.csv", "none.csv");
  expect_bad_input(measure + "--displacements cube.inp", ".vtu or .csv, got .inp");
  expect_bad_input(measure + "--displacements f.csv", "f.csv:1: columns");
  expect_bad_input(measure + "--displacements u.csv --forces u.csv", "u.csv:1: columns");
  expect_bad_input(measure + "--displacements u.csv --cells 5,5,5", "216 nodes");
  expect_bad_input(measure + "--displacements u.csv --method mss-cf", "--method");
  for (const char* unread : {"--stiffness-form E", "--spring-strain green"})
    expect_bad_input(measure + "--displacements u.csv " + unread,
                     "which neither what is measured nor its reference reads");
  expect_bad_input("measure uniaxial --displacements u.csv", "--label");
  expect_bad_input("measure uniaxial --displacements u.csv --label fem-stvk",
                   "another name than the methods' own");
  std::ofstream(folder / "huge.csv") << "node,ux,uy,uz\n1,1e200,0,0\n";
  expect_bad_input(measure + "--displacements huge.csv", "none of 124 of them");
}

// What belongs to half of the load is right, and what to all of it is not.
BOOST_AUTO_TEST_CASE(a_path_s_last_load_is_what_is_measured) {
  const auto measured = [](double shear) {
    std::ostringstream csv;
    csv << "x,y,z,ux,uy,uz\n";
    for (const double x : {0., 0.025, 0.05})
      for (const double y : {0., 0.025, 0.05})
        for (const double z : {0., 0.025, 0.05})
          csv << x << "," << y << "," << z << "," << shear * z << ",0,0\n";
    std::ofstream(folder / "sheared.csv") << csv.str();
    return run_springcheck(
        "measure shearing --cells 2,2,2 --deformation 10% --solver verlet "
        "--load-times 2 --load-fractions 0.5 --displacements sheared.csv --label mine "
        "--json");
  };
  const Run half = measured(0.05), whole = measured(0.1);
  BOOST_TEST(half.err.find("do not follow") == std::string::npos, half.err);
  const Json result = Json::parse(half.out)["results"][0];
  BOOST_TEST(result["deformation"] == 0.05);
  BOOST_TEST(result["reason"].is_null());
  BOOST_TEST(whole.err.find("do not follow the scene's supports") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_measured_result_that_is_inverted_exits_3) {
  std::ofstream file(folder / "inverted.csv");
  file << "node,ux,uy,uz\n";
  for (int node = 1; node <= 27; ++node)
    file << node << "," << (node == 14 ? 0.06 : 0) << ",0,0\n";  // the one in the middle
  file.close();
  const Run run = run_springcheck(
      "measure compression --cells 2,2,2 --displacements inverted.csv --label x --json");
  BOOST_TEST(run.status == 3);
  BOOST_TEST(Json::parse(run.out)["results"][0]["status"] == "inverted");
}

BOOST_AUTO_TEST_SUITE_END()
