#define BOOST_TEST_MODULE fem_reference_discretisation
#include "fem_reference/discretisation.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "bodies.hpp"
#include "fem_reference/loads.hpp"
#include "laws.hpp"

// Nodes, shape functions and consistent loads. What is exact on paper has round-off as
// its tolerance.

using namespace springcheck;
using namespace springcheck::fem_reference;

namespace {

const auto round_off = boost::test_tools::tolerance(1e-12);

Mesh warped(int cells) {
  return distorted_cube(cells, 0.15, Moved::all_nodes);
}

/// Gradient of a nodal field at a Gauss point.
Matrix3 gradient_at(const Eigen::VectorXd& field, const Cell& cell, Eigen::Index point) {
  return of_cell(field, cell) * cell.shape->gradients_at(point).transpose();
}

}  // namespace

BOOST_AUTO_TEST_CASE(vertices_keep_the_numbers_of_the_mesh) {
  const Mesh mesh = renumbered(warped(3));
  for (const Element element : elements) {
    const Discretisation body = discretise(mesh, element);
    BOOST_TEST(body.vertices == mesh.nodes().size());
    for (std::size_t n = 0; n < body.vertices; ++n)
      BOOST_TEST((body.nodes[n] == mesh.nodes()[n]));
    for (std::size_t c = 0; c < body.cells.size(); ++c)
      BOOST_TEST(
          (std::set(body.cells[c].nodes.begin(), body.cells[c].nodes.begin() + 8) ==
           std::set(mesh.cells()[c].begin(), mesh.cells()[c].end())));
  }
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

// All fields of first degree, on warped cells too.
BOOST_AUTO_TEST_CASE(shape_functions_reproduce_affine_fields) {
  const Matrix3 H = general_gradient();
  const Mesh mesh = warped(2);
  for (const Element element : elements) {
    const Discretisation body = discretise(mesh, element);
    const Eigen::VectorXd affine =
        nodal(body, [&](const Vector3& x) -> Vector3 { return H * x; });
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
      const Cell& cell = body.cells[c];
      BOOST_TEST(cell.shape->volume == mesh.cell_volumes()[c], round_off);
      BOOST_TEST(cell.shape->weights.sum() == mesh.cell_volumes()[c], round_off);
      for (Eigen::Index q = 0; q <= cell.shape->weights.size(); ++q)  // and the mean
        BOOST_TEST(largest(gradient_at(affine, cell, q) - H) < 1e-12);
    }
    for (const double sum : body.cells.front().shape->values->rowwise().sum())
      BOOST_TEST(sum == 1, round_off);
  }
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
  const Discretisation irregular = discretise(warped(3), Element::q1);
  std::set<const Shape*> shapes;
  for (const Cell& cell : irregular.cells) shapes.insert(cell.shape.get());
  BOOST_TEST(shapes.size() == 27U);
  // Cells that differ in one corner by a millionth of their edge.
  const Mesh nearly = mapped(cube(3), [](const Vector3& x) -> Vector3 {
    return x.minCoeff() > 0.99 * edge ? x + Vector3(0, 0, 1e-6 * edge / 3) : x;
  });
  const Discretisation body = discretise(nearly, Element::q1);
  BOOST_TEST(body.cells.back().shape != body.cells.front().shape);
}

// Weight of a warped body: total exact, and the same moments as the body itself, since
// int sum_a N_a X_a dV = int X dV.
BOOST_AUTO_TEST_CASE(body_load_has_the_resultant_and_the_moment_of_its_density) {
  const Vector3 density(2, -3, 5);  // N/m^3
  const Mesh mesh = warped(2);
  for (const Element element : elements) {
    const Discretisation body = discretise(mesh, element);
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
  }
}

// int N dA over a square face: a quarter of it at each corner for q1; 1/36 at corners,
// 4/36 at edges' middles and 16/36 at the face's for q2.
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

// On a region of several faces, on a side with curved faces: the area by Gauss's formula
// on the mesh's own bilinear faces, of high enough order to be exact to 1e-6 (their area
// element is the root of a polynomial).
BOOST_AUTO_TEST_CASE(traction_is_the_stress_times_the_undeformed_area) {
  const Vector3 stress(7, 5, -11);
  const Mesh flat = cube(3), curved = warped(3);
  for (const Element element : elements)
    for (const auto& [name, region] : flat.regions())
      BOOST_TEST((total(traction_load(discretise(flat, element),
                                      {.region = name, .stress = stress})) -
                  edge * edge * stress)
                     .norm() < 1e-12 * edge * edge);
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
