#include "dynamics/explicit_motion.hpp"

#include <algorithm>
#include <array>

#include "dynamics/nodal_update.hpp"
#include "dynamics/shared_nodes.hpp"
#include "dynamics/workers.hpp"

namespace springcheck::dynamics {
namespace {

/// A support of one element of a block's arrays.
struct Held {
  std::uint32_t element;
  NodeIndex node;
  std::uint32_t motion;
  std::uint8_t component;
};

template <class Real>
class ExplicitMotion final : public Motion {
 public:
  ExplicitMotion(ExplicitBody<Real> body, const ExplicitSettings& settings)
      : body_(std::move(body)),
        integrator_(settings.integrator),
        update_(nodal_update<Real>(settings.instruction_set)),
        workers_(settings.threads),
        shared_(shared_nodes(body_.blocks)) {
    const bool loaded = std::ranges::any_of(
        body_.load, [](const Vector3& f) { return f != Vector3::Zero(); });
    for (const Block& block : body_.blocks)
      states_.emplace_back(block, loaded ? Load::some : Load::none, body_.forces.lanes);
    for (std::size_t b = 0; b < states_.size(); ++b) {
      const BlockArrays<Real>& arrays = states_[b].arrays();
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        arrays.inverse_mass[at] = static_cast<Real>(1 / body_.masses[node]);
        if (loaded)
          for (std::size_t i = 0; i < 3; ++i)
            arrays.load[i][at] =
                static_cast<Real>(body_.load[node][static_cast<Eigen::Index>(i)]);
      });
      for (std::uint32_t& slot : shared_.slots[b])  // from here on elements
        slot = static_cast<std::uint32_t>(arrays.element(slot));
    }
    for (auto& box : outbox_) box.resize(shared_.entries);
    find_held_elements();
    compute_all_forces();
  }

  void advance(const StepTo& step) override {
    workers_.run(states_.size(), [&](std::size_t b) {
      collect_shared_forces(b);
      update_(states_[b].arrays(), {.integrator = integrator_,
                                    .dt = step.dt,
                                    .kick = step.kick,
                                    .load_fraction = step.load_fraction});
      move_supports(b, step);
      compute_forces(b, 1 - parity_);
    });
    parity_ = 1 - parity_;
  }

  [[nodiscard]] State state() const override {
    State state{.displacements = std::vector<Vector3>(body_.rest.size()),
                .velocities = std::vector<Vector3>(body_.rest.size())};
    for (std::size_t b = 0; b < states_.size(); ++b) {
      const BlockArrays<Real>& arrays = states_[b].arrays();
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        state.displacements[node] = vector(arrays.displacement, at);
        state.velocities[node] = vector(arrays.velocity, at);
      });
    }
    return state;
  }

  void restore(const State& state) override {
    for (std::size_t b = 0; b < states_.size(); ++b) {
      const BlockArrays<Real>& arrays = states_[b].arrays();
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        for (std::size_t i = 0; i < 3; ++i) {
          const auto j = static_cast<Eigen::Index>(i);
          arrays.displacement[i][at] = static_cast<Real>(state.displacements[node][j]);
          arrays.velocity[i][at] = static_cast<Real>(state.velocities[node][j]);
        }
      });
    }
    compute_all_forces();
  }

  [[nodiscard]] std::vector<Vector3> forces_at(const State& state) override {
    restore(state);
    std::vector<Vector3> forces(body_.rest.size());
    for (std::size_t b = 0; b < states_.size(); ++b) {
      collect_shared_forces(b);
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        forces[node] = vector(states_[b].arrays().force, at);
      });
    }
    return forces;
  }

 private:
  /// visit(element of the arrays, node of the mesh).
  template <class Visit>
  void for_each_node(std::size_t b, const Visit& visit) const {
    const std::vector<NodeIndex>& nodes = body_.blocks[b].nodes;
    for (std::size_t slot = 0; slot < nodes.size(); ++slot)
      if (nodes[slot] != no_node) visit(states_[b].arrays().element(slot), nodes[slot]);
  }

  static Vector3 vector(const std::array<Real*, 3>& field, std::size_t at) {
    return {field[0][at], field[1][at], field[2][at]};
  }

  void find_held_elements() {
    std::ranges::sort(body_.supports, {}, &Support::node);
    held_.resize(states_.size());
    for (std::size_t b = 0; b < states_.size(); ++b)
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        for (const Support& support :
             std::ranges::equal_range(body_.supports, node, {}, &Support::node))
          held_[b].push_back({.element = static_cast<std::uint32_t>(at),
                              .node = node,
                              .motion = support.motion,
                              .component = support.component});
      });
  }

  void compute_all_forces() {
    workers_.run(states_.size(), [&](std::size_t b) { compute_forces(b, parity_); });
  }

  void compute_forces(std::size_t b, int parity) {
    states_[b].clear_forces();
    const BlockArrays<Real>& arrays = states_[b].arrays();
    body_.forces.add(b, arrays);
    auto entry = static_cast<std::size_t>(shared_.first_entry[b]);
    for (const std::uint32_t at : shared_.slots[b]) {
      for (std::size_t i = 0; i < 3; ++i) outbox_[parity][entry][i] = arrays.force[i][at];
      ++entry;
    }
  }

  void collect_shared_forces(std::size_t b) {
    const BlockArrays<Real>& arrays = states_[b].arrays();
    const std::vector<std::uint32_t>& elements = shared_.slots[b];
    for (std::size_t n = 0; n < elements.size(); ++n) {
      std::array<Real, 3> sum{};
      for (const std::uint32_t entry : shared_.copies(b, n))
        for (std::size_t i = 0; i < 3; ++i) sum[i] += outbox_[parity_][entry][i];
      for (std::size_t i = 0; i < 3; ++i) arrays.force[i][elements[n]] = sum[i];
    }
  }

  void move_supports(std::size_t b, const StepTo& step) {
    const BlockArrays<Real>& arrays = states_[b].arrays();
    for (const auto& [at, node, motion, component] : held_[b]) {
      const Vector3& point = body_.rest[node];
      const double now = step.motions[motion].component(point, component);
      const double before = step.motions_before[motion].component(point, component);
      arrays.displacement[component][at] = static_cast<Real>(now);
      arrays.velocity[component][at] = static_cast<Real>((now - before) / step.dt);
    }
  }

  ExplicitBody<Real> body_;
  Integrator integrator_;
  NodalUpdate<Real> update_;
  Workers workers_;
  std::vector<std::vector<Held>> held_;
  SharedNodes shared_;
  std::vector<BlockState<Real>> states_;
  // Forces of the blocks on the nodes they share, of this step and for the next in turn:
  std::array<std::vector<std::array<Real, 3>>, 2> outbox_;
  int parity_ = 0;
};

}  // namespace

template <class Real>
std::unique_ptr<Motion> explicit_motion(ExplicitBody<Real> body,
                                        const ExplicitSettings& settings) {
  return std::make_unique<ExplicitMotion<Real>>(std::move(body), settings);
}

template std::unique_ptr<Motion> explicit_motion(ExplicitBody<double> body,
                                                 const ExplicitSettings& settings);
template std::unique_ptr<Motion> explicit_motion(ExplicitBody<float> body,
                                                 const ExplicitSettings& settings);

}  // namespace springcheck::dynamics
