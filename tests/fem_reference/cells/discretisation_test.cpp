#include "fem_reference/cells/discretisation.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "fem_reference/statics/loads.hpp"
#include "meshing/cell_geometry.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// Nodes, shape functions and consistent loads. What is exact on paper has round-off as
// its tolerance.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(discretisation_test)

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

/// Calls the test with every element on irregular cells of every type, nodes in disorder.
void for_all_bodies(const std::function<void(const Mesh&, const Discretisation&)>& test) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = renumbered(warped_cube(3, pattern));
    for (const Element element : elements_on(pattern))
      BOOST_TEST_CONTEXT(words(pattern) << ' ' << words(element))
    test(mesh, discretise(mesh, element));
  }
}

std::set<const Shape*> shapes_of(const Discretisation& body) {
  std::set<const Shape*> shapes;
  for (const Cell& cell : body.cells) shapes.insert(cell.shape.get());
  return shapes;
}

/// Gradient of a nodal field at a Gauss point.
Matrix3 gradient_at(const Eigen::VectorXd& field, const Cell& cell, Eigen::Index point) {
  return of_cell(field, cell) * cell.shape->gradients_at(point).transpose();
}

}  // namespace

BOOST_AUTO_TEST_CASE(vertices_and_cells_keep_the_numbers_of_the_mesh) {
  for_all_bodies([](const Mesh& mesh, const Discretisation& body) {
    BOOST_TEST(body.vertices == mesh.nodes().size());
    for (std::size_t n = 0; n < body.vertices; ++n)
      BOOST_TEST((body.nodes[n] == mesh.nodes()[n]));
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
      const CellNodes& expected = mesh.cells()[c];
      const auto corners = std::span(body.cells[c].nodes).first(expected.size());
      BOOST_TEST((std::set(corners.begin(), corners.end()) ==
                  std::set(expected.begin(), expected.end())));
    }
  });
}

// Both follow from exact integrals over bilinear faces: dV/dX_a = int grad N_a dV. The
// tolerance is round-off: a pyramid's points and weights have 14 digits.
BOOST_AUTO_TEST_CASE(cells_have_the_exact_volume_and_its_exact_gradient) {
  for_all_bodies([](const Mesh& mesh, const Discretisation& body) {
    if (body.nodes.size() > body.vertices) return;  // other shape functions
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
      const auto& [nodes, shape] = body.cells[c];
      BOOST_TEST(shape->volume == mesh.cell_volumes()[c], round_off);
      const CornerPositions expected =
          cell_volume_gradient(corners(mesh.cells()[c], mesh.nodes()));
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto place =
            std::ranges::find(mesh.cells()[c], nodes[a]) - mesh.cells()[c].begin();
        BOOST_TEST(
            (shape->volume * shape->mean_gradients().col(static_cast<Eigen::Index>(a)) -
             expected.col(place))
                .norm() < 1e-13 * expected.norm());
      }
    }
  });
}

// 3^3 cells have 7^3 triquadratic nodes, at the means of two, four or eight vertices.
BOOST_AUTO_TEST_CASE(triquadratic_nodes_lie_between_vertices) {
  const Discretisation body = discretise(renumbered(cube(3)), Element::q2);
  BOOST_TEST(body.nodes.size() == 343U);
  BOOST_TEST(body.parents.size() == 343U - 64U);
  std::map<std::size_t, int> kinds;
  for (std::size_t i = 0; i < body.parents.size(); ++i) {
    Vector3 mean = Vector3::Zero();
    for (const NodeIndex parent : body.parents[i])
      mean += body.nodes[parent] / static_cast<double>(body.parents[i].size());
    BOOST_TEST((mean - body.nodes[body.vertices + i]).norm() < 1e-16);
    BOOST_TEST(std::ranges::is_sorted(body.parents[i]));
    ++kinds[body.parents[i].size()];
  }
  BOOST_TEST(kinds[2] == 3 * 4 * 4 * 3);  // edges
  BOOST_TEST(kinds[4] == 3 * 4 * 3 * 3);  // faces
  BOOST_TEST(kinds[8] == 27);
}

// All fields of first degree, and the place X itself, are reproduced at the Gauss points
// by values and by gradients.
BOOST_AUTO_TEST_CASE(shape_functions_reproduce_affine_fields) {
  const Matrix3 H = general_gradient();
  for_all_bodies([&](const Mesh& mesh, const Discretisation& body) {
    const Eigen::VectorXd affine =
        nodal(body, [&](const Vector3& x) -> Vector3 { return H * x; });
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
      const Cell& cell = body.cells[c];
      BOOST_TEST(cell.shape->volume == mesh.cell_volumes()[c], round_off);
      BOOST_TEST(cell.shape->weights.sum() == mesh.cell_volumes()[c], round_off);
      for (Eigen::Index q = 0; q <= cell.shape->weights.size(); ++q)  // and the mean
        BOOST_TEST(largest(gradient_at(affine, cell, q) - H) < 1e-12);
      BOOST_TEST((cell.shape->values->rows() == cell.shape->weights.size()));
      for (const double sum : cell.shape->values->rowwise().sum())
        BOOST_TEST(sum == 1, round_off);
    }
  });
}

// u = (x y, y z, x^2 - z^2) on cubes: q2's own.
BOOST_AUTO_TEST_CASE(triquadratic_cells_reproduce_quadratic_fields) {
  const Discretisation body = discretise(cube(2), Element::q2);
  const Eigen::VectorXd field = nodal(body, [](const Vector3& X) -> Vector3 {
    return {X.x() * X.y(), X.y() * X.z(), X.x() * X.x() - X.z() * X.z()};
  });
  const Eigen::VectorXd places = nodal(body, [](const Vector3& X) { return X; });
  for (const Cell& cell : body.cells)
    for (Eigen::Index q = 0; q < cell.shape->weights.size(); ++q) {
      const Vector3 X = of_cell(places, cell) * cell.shape->values->row(q).transpose();
      Matrix3 H;
      H << X.y(), X.x(), 0, 0, X.z(), X.y(), 2 * X.x(), 0, -2 * X.z();
      BOOST_TEST(largest(gradient_at(field, cell, q) - H) < 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(translated_cells_share_their_shape_and_others_do_not) {
  const Discretisation regular = discretise(cube(3), Element::q1);
  for (const Cell& cell : regular.cells)
    BOOST_TEST(cell.shape == regular.cells.front().shape);
  for (const CellPattern pattern : patterns) {
    const Discretisation irregular = discretise(warped_cube(3, pattern), Element::q1);
    BOOST_TEST(shapes_of(irregular).size() == irregular.cells.size());
  }
  // Cells that differ in one corner by a millionth of their edge.
  const Mesh nearly = mapped(cube(3), [](const Vector3& x) -> Vector3 {
    return x.minCoeff() > 0.99 * edge ? x + Vector3(0, 0, 1e-6 * edge / 3) : x;
  });
  const Discretisation body = discretise(nearly, Element::q1);
  BOOST_TEST(body.cells.back().shape != body.cells.front().shape);
}

// There are as many shapes as a hexahedron is cut into, however many hexahedra there are.
BOOST_AUTO_TEST_CASE(cells_of_a_regular_pattern_share_the_shapes_of_its_period) {
  for (const auto& [pattern, period] : {std::pair{CellPattern::prism, 2U},
                                        {CellPattern::pyramid, 6U},
                                        {CellPattern::tetrahedron, 6U}}) {
    const Discretisation body = discretise(cube(4, pattern), Element::q1);
    BOOST_TEST(body.cells.size() == 64 * period);
    BOOST_TEST(shapes_of(body).size() == period);
  }
}

// A tetrahedron whose corners are the first four of a prism.
BOOST_AUTO_TEST_CASE(cells_of_different_types_never_share_their_shape,
                     *boost::unit_test::tolerance(1e-14)) {
  std::vector<Vector3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vector3& x : std::vector(nodes))
    nodes.emplace_back(x + 3 * Vector3::UnitX());
  nodes.emplace_back(4, 0, 1);
  nodes.emplace_back(3, 1, 1);
  const Discretisation body = discretise(
      {"two cells", nodes, {{0, 1, 2, 3}, {4, 5, 6, 7, 8, 9}}, {}}, Element::q1);
  BOOST_TEST(body.cells[0].shape->volume == 1. / 6);
  BOOST_TEST(body.cells[1].shape->volume == 1. / 2);
}

// The weight of a warped body has the exact total, and the same moments as the body
// itself, since int sum_a N_a X_a dV = int X dV.
BOOST_AUTO_TEST_CASE(body_load_has_the_resultant_and_the_moment_of_its_density) {
  const Vector3 density(2, -3, 5);  // N/m^3
  for_all_bodies([&](const Mesh& mesh, const Discretisation& body) {
    const Eigen::VectorXd load = body_load(body, [&](const Vector3&) { return density; });
    BOOST_TEST((total(load) - mesh.volume() * density).norm() <
               1e-12 * mesh.volume() * density.norm());
    // A density proportional to x has the resultant int x dV, which the uniform one has
    // as its moment.
    const Eigen::VectorXd slanted =
        body_load(body, [&](const Vector3& X) -> Vector3 { return X.x() * density; });
    Vector3 moment = Vector3::Zero();
    for (std::size_t n = 0; n < body.nodes.size(); ++n)
      moment += body.nodes[n].x() * load.segment<3>(static_cast<Eigen::Index>(3 * n));
    BOOST_TEST((total(slanted) - moment).norm() < 1e-12 * moment.norm());
  });
}

// int X dV is exact in every cell, whatever its shape: a cube's weight acts at its
// centre.
BOOST_AUTO_TEST_CASE(weight_acts_at_the_centre_of_a_distorted_cube) {
  const Vector3 centre = Vector3::Constant(edge / 2);
  for (const CellPattern pattern : patterns)
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(cube(3, pattern, 0.2), element);
      const Eigen::VectorXd load =
          body_load(body, [](const Vector3&) -> Vector3 { return Vector3::UnitZ(); });
      Vector3 moment = Vector3::Zero();
      for (std::size_t n = 0; n < body.nodes.size(); ++n)
        moment += load[static_cast<Eigen::Index>(3 * n + 2)] * body.nodes[n];
      BOOST_TEST((moment / total(load).z() - centre).norm() < 1e-13 * edge);
    }
}

// int N dA over a square face is a quarter of it at each corner for q1; for q2 it is 1/36
// at corners, 4/36 at edges' middles and 16/36 at the face's.
BOOST_AUTO_TEST_CASE(traction_on_a_face_is_shared_out_consistently) {
  const Vector3 stress(7, 0, -11);  // Pa
  const Traction pull{.region = "top", .stress = stress};
  for (const Element element : elements) {
    const Discretisation body = discretise(cube(1), element);
    const Eigen::VectorXd load = traction_load(body, pull);
    for (std::size_t n = 0; n < body.nodes.size(); ++n) {
      const Vector3 X = body.nodes[n] / edge;
      double share = 0;
      if (X.z() > 0.99) {
        const int middles = (std::abs(X.x() - 0.5) < 0.1) + (std::abs(X.y() - 0.5) < 0.1);
        share = element == Element::q2 ? std::pow(4, middles) / 36 : 0.25;
      }
      BOOST_TEST((load.segment<3>(static_cast<Eigen::Index>(3 * n)) -
                  share * edge * edge * stress)
                     .norm() < 1e-12 * edge * edge);
    }
  }
}

// On every side of the cube, of triangles, quadrilaterals or both, the force is the
// stress times the area, and acts at the side's centre. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(traction_on_plane_sides_acts_at_their_centres) {
  const Vector3 stress(7, 5, -11);
  const std::map<std::string, Vector3> centres{
      {"x_min", {0, 0.5, 0.5}},  {"x_max", {1, 0.5, 0.5}},  //
      {"y_min", {0.5, 0, 0.5}},  {"y_max", {0.5, 1, 0.5}},  //
      {"bottom", {0.5, 0.5, 0}}, {"top", {0.5, 0.5, 1}}};
  for (const CellPattern pattern : patterns)
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(renumbered(cube(3, pattern, 0.2)), element);
      BOOST_TEST(body.regions.size() == centres.size());
      for (const auto& [name, centre] : centres) {
        const Eigen::VectorXd load =
            traction_load(body, {.region = name, .stress = stress});
        BOOST_TEST((total(load) - edge * edge * stress).norm() < 1e-12 * edge * edge);
        Vector3 moment = Vector3::Zero();
        for (std::size_t n = 0; n < body.nodes.size(); ++n)
          moment += load[static_cast<Eigen::Index>(3 * n)] / stress.x() * body.nodes[n];
        BOOST_TEST((moment - edge * edge * edge * centre).norm() <
                   1e-12 * edge * edge * edge);
        const Eigen::VectorXd places = nodal(body, [](const Vector3& X) { return X; });
        BOOST_TEST((mean_displacement(body, name, places) - edge * centre).norm() <
                   1e-12 * edge);
      }
    }
}

// On a side with curved faces the area is found by the midpoint rule on the mesh's own
// bilinear faces, exact to some 1e-4 (their area element is the root of a polynomial).
BOOST_AUTO_TEST_CASE(traction_on_curved_sides_is_the_stress_times_the_area) {
  const Vector3 stress(7, 5, -11);
  const Mesh curved = warped_cube(3, CellPattern::hexahedron);
  double area = 0;
  for (const FaceNodes& face : curved.region("x_max").faces) {
    constexpr int points = 20;  // midpoint rule, error of the order 1/points^2
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j) {
        const double s = (i + 0.5) / points, t = (j + 0.5) / points;
        const auto X = [&](int n) {
          return curved.nodes()[face[static_cast<std::size_t>(n)]];
        };
        const Vector3 along_s = (1 - t) * (X(1) - X(0)) + t * (X(2) - X(3));
        const Vector3 along_t = (1 - s) * (X(3) - X(0)) + s * (X(2) - X(1));
        area += along_s.cross(along_t).norm() / (points * points);
      }
  }
  for (const Element element : elements)
    BOOST_TEST((total(traction_load(discretise(curved, element),
                                    {.region = "x_max", .stress = stress})) -
                area * stress)
                   .norm() < 1e-4 * area * stress.norm());
}

BOOST_AUTO_TEST_SUITE_END()
