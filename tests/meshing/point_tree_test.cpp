#include "meshing/point_tree.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

namespace springcheck {
namespace {

BOOST_AUTO_TEST_SUITE(point_tree_test)

struct Cloud {
  std::vector<Vector3> positions;
  std::vector<NodeIndex> nodes;  // every third position
};

Cloud cloud(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  Cloud cloud;
  for (NodeIndex n = 0; n < 1000; ++n) {
    cloud.positions.emplace_back(place(random), place(random), place(random));
    if (n % 3 == 0) cloud.nodes.push_back(n);
  }
  return cloud;
}

BOOST_AUTO_TEST_CASE(nodes_in_boxes_are_those_that_a_look_at_all_finds) {
  const Cloud given = cloud(1), corners = cloud(2);
  const PointTree tree(given.positions, given.nodes);
  for (std::size_t i = 0; i + 1 < corners.positions.size(); i += 10) {
    Eigen::AlignedBox3d box(corners.positions[i]);
    box.extend(corners.positions[i + 1]);
    std::vector<NodeIndex> expected;
    std::ranges::copy_if(given.nodes, std::back_inserter(expected),
                         [&](NodeIndex n) { return box.contains(given.positions[n]); });
    BOOST_TEST(tree.in_box(box) == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_box_has_its_sides) {
  const std::vector<Vector3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}};
  const std::vector<NodeIndex> nodes{0, 1, 2}, first_two{0, 1};
  const PointTree tree(positions, nodes);
  const Eigen::AlignedBox3d edge(positions[0], positions[1]);
  BOOST_TEST(tree.in_box(edge) == first_two, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_nearest_node_is_found_from_everywhere) {
  const Cloud given = cloud(1), points = cloud(3);
  const PointTree tree(given.positions, given.nodes);
  for (const double scale : {1., 10., 1e300})
    for (std::size_t i = 0; i < points.positions.size(); i += 10) {
      const Vector3 point = scale * points.positions[i];
      const auto distance = [&](NodeIndex n) {
        return (given.positions[n] - point).norm();
      };
      const NodeIndex nearest = tree.nearest(point);
      BOOST_TEST(std::ranges::binary_search(given.nodes, nearest));
      BOOST_TEST(distance(nearest) ==
                 distance(std::ranges::min(given.nodes, {}, distance)));
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace springcheck
