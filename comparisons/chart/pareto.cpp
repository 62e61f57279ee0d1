#include "comparisons/chart/pareto.hpp"

#include <algorithm>
#include <tuple>

namespace springcheck {

std::vector<std::size_t> pareto_front(std::span<const Cost> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].error && points[i].seconds) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::tuple(*points[i].seconds, *points[i].error);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() ||
        *points[i].error < (1 - worthwhile_gain) * *points[front.back()].error)
      front.push_back(i);
  return front;
}

}  // namespace springcheck
