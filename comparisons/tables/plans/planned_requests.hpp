#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/settings/scene_file.hpp"

namespace springcheck {

/// What small deformations are held against on finer and finer cubes. Of a linear law one
/// factor is all: at nu = .499 9 s on 16 cells across, where multigrid takes 64 and
/// conjugate gradients more.
inline const GivenSettings exact_elements{
    {"method", "fem-hooke"}, {"element", "q2"}, {"linear-solver", "direct"}};

/// The simulations of a table while it is planned: each is known by its place.
class PlannedRequests {
 public:
  std::size_t add(const CaseSettings& settings) {
    requests_.push_back({.settings = settings});
    return requests_.size() - 1;
  }
  std::size_t add(const std::string& scene, const GivenSettings& changes) {
    return add(case_of_scene(scene, changes));
  }

  [[nodiscard]] std::vector<Request> take() { return std::move(requests_); }

 private:
  std::vector<Request> requests_;
};

}  // namespace springcheck
