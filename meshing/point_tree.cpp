#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry includes them itself
#include "meshing/point_tree.hpp"

#include <algorithm>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

namespace springcheck {
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using PlacedNode = std::pair<Point, NodeIndex>;

Point point_at(const Vector3& x) {
  return {x[0], x[1], x[2]};
}

std::vector<PlacedNode> placed(std::span<const Vector3> positions,
                               std::span<const NodeIndex> nodes) {
  std::vector<PlacedNode> placed;
  for (const NodeIndex n : nodes) placed.emplace_back(point_at(positions[n]), n);
  return placed;
}

}  // namespace

struct PointTree::Tree {
  geometry::index::rtree<PlacedNode, geometry::index::rstar<16>> nodes;
};

PointTree::PointTree(std::span<const Vector3> positions, std::span<const NodeIndex> nodes)
    : tree_(new Tree{decltype(Tree::nodes)(placed(positions, nodes))}) {}

PointTree::~PointTree() = default;

std::vector<NodeIndex> PointTree::in_box(const Eigen::AlignedBox3d& box) const {
  std::vector<NodeIndex> found;
  const Box sides(point_at(box.min()), point_at(box.max()));
  for (auto it = tree_->nodes.qbegin(geometry::index::intersects(sides));
       it != tree_->nodes.qend(); ++it)
    found.push_back(it->second);
  std::ranges::sort(found);
  return found;
}

NodeIndex PointTree::nearest(const Vector3& point) const {
  return tree_->nodes.qbegin(geometry::index::nearest(point_at(point), 1))->second;
}

}  // namespace springcheck
