#include "dynamics/blocks/explicit_motion.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "dynamics/blocks/nodal_update.hpp"
#include "dynamics/blocks/shared_nodes.hpp"
#include "dynamics/blocks/workers.hpp"

namespace springcheck::dynamics {
namespace {

/// What one component of a motion moves of a block's arrays: elements, and their points
/// at rest [m].
struct Held {
  std::uint32_t motion;
  std::uint8_t component;
  std::vector<std::uint32_t> elements{};
  std::vector<Vector3> points{};
};

template <class Real>
class ExplicitMotion final : public Motion {
 public:
  ExplicitMotion(ExplicitBody<Real> body, const ExplicitSettings& settings)
      : node_count_(body.rest.size()),
        blocks_(std::move(body.blocks)),
        block_forces_(std::move(body.forces)),
        integrator_(settings.integrator),
        update_(nodal_update<Real>(settings.instruction_set)),
        workers_(settings.threads),
        shared_(shared_nodes(blocks_)) {
    const bool loaded = std::ranges::any_of(
        body.load, [](const Vector3& f) { return f != Vector3::Zero(); });
    for (const Block& block : blocks_)
      states_.emplace_back(
          block, block_forces_.lanes,
          OptionalArrays{.load = loaded,
                         .nodal_sum = block_forces_.add_nodal_sums != nullptr});
    for (std::size_t b = 0; b < states_.size(); ++b) {
      const BlockArrays<Real>& arrays = states_[b].arrays();
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        arrays.inverse_mass[at] = static_cast<Real>(1 / body.masses[node]);
        if (loaded)
          for (std::size_t i = 0; i < 3; ++i)
            arrays.load[i][at] =
                static_cast<Real>(body.load[node][static_cast<Eigen::Index>(i)]);
      });
      for (std::uint32_t& slot : shared_.slots[b])  // from here on elements
        slot = static_cast<std::uint32_t>(arrays.element(slot));
    }
    for (auto& box : outbox_) box.resize(shared_.entries);
    if (block_forces_.add_nodal_sums) sums_outbox_.resize(shared_.entries);
    find_held_elements(std::move(body.supports), body.rest);
    compute_all_forces();
  }

  void advance(const StepTo& step) override {
    const auto move = [&](std::size_t b) {
      collect(b, outbox_[parity_], states_[b].arrays().force);
      update_(states_[b].arrays(), {.integrator = integrator_,
                                    .dt = step.dt,
                                    .kick = step.kick,
                                    .load_fraction = step.load_fraction});
      move_supports(b, step);
    };
    compute_forces_after(move, 1 - parity_);
    parity_ = 1 - parity_;
  }

  [[nodiscard]] State state() const override {
    State state{.displacements = std::vector<Vector3>(node_count_),
                .velocities = std::vector<Vector3>(node_count_)};
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
    std::vector<Vector3> forces(node_count_);
    for (std::size_t b = 0; b < states_.size(); ++b) {
      collect(b, outbox_[parity_], states_[b].arrays().force);
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
    const std::vector<NodeIndex>& nodes = blocks_[b].nodes;
    for (std::size_t slot = 0; slot < nodes.size(); ++slot)
      if (nodes[slot] != no_node) visit(states_[b].arrays().element(slot), nodes[slot]);
  }

  static Vector3 vector(const std::array<Real*, 3>& field, std::size_t at) {
    return {field[0][at], field[1][at], field[2][at]};
  }

  void find_held_elements(std::vector<Support> supports, std::span<const Vector3> rest) {
    std::ranges::sort(supports, {}, &Support::node);
    held_.resize(states_.size());
    for (std::size_t b = 0; b < states_.size(); ++b)
      for_each_node(b, [&](std::size_t at, NodeIndex node) {
        for (const Support& support :
             std::ranges::equal_range(supports, node, {}, &Support::node)) {
          Held& held = held_by(b, support);
          held.elements.push_back(static_cast<std::uint32_t>(at));
          held.points.push_back(rest[node]);
        }
      });
  }

  Held& held_by(std::size_t b, const Support& support) {
    const auto found = std::ranges::find_if(held_[b], [&](const Held& held) {
      return held.motion == support.motion && held.component == support.component;
    });
    if (found != held_[b].end()) return *found;
    held_[b].push_back({.motion = support.motion, .component = support.component});
    return held_[b].back();
  }

  void compute_all_forces() {
    compute_forces_after([](std::size_t) {}, parity_);
  }

  /// Calls move(block) for each, before any block's forces that depend on it.
  template <class Move>
  void compute_forces_after(const Move& move, int parity) {
    const std::size_t blocks = states_.size();
    if (!block_forces_.add_nodal_sums) {
      workers_.run(blocks, [&](std::size_t b) {
        move(b);
        compute_forces(b, parity);
      });
      return;
    }
    workers_.run(blocks, [&](std::size_t b) {
      move(b);
      states_[b].clear_nodal_sum();
      block_forces_.add_nodal_sums(b, states_[b].arrays());
      post(b, std::array{states_[b].arrays().nodal_sum}, sums_outbox_);
    });
    workers_.run(blocks, [&](std::size_t b) {
      collect(b, sums_outbox_, std::array{states_[b].arrays().nodal_sum});
      compute_forces(b, parity);
    });
  }

  void compute_forces(std::size_t b, int parity) {
    states_[b].clear_forces();
    block_forces_.add(b, states_[b].arrays());
    post(b, states_[b].arrays().force, outbox_[parity]);
  }

  template <std::size_t n>
  using Outbox = std::vector<std::array<Real, n>>;

  /// Hands what the block has on the nodes it shares to the others.
  template <std::size_t n>
  void post(std::size_t b, const std::array<Real*, n>& field, Outbox<n>& outbox) const {
    std::size_t entry = shared_.first_entry[b];
    for (const std::uint32_t at : shared_.slots[b]) {
      for (std::size_t i = 0; i < n; ++i) outbox[entry][i] = field[i][at];
      ++entry;
    }
  }

  /// Sums what all blocks have on them, in the order of the blocks. Of two the order
  /// makes no difference, and most nodes have two.
  template <std::size_t n>
  void collect(std::size_t b, const Outbox<n>& outbox,
               const std::array<Real*, n>& field) const {
    const std::vector<std::uint32_t>& elements = shared_.slots[b];
    const auto others = std::span(shared_.only_other).subspan(shared_.first_entry[b]);
    for (std::size_t node = 0; node < elements.size(); ++node) {
      if (others[node] != SharedNodes::many) {
        const std::array<Real, n>& other = outbox[others[node]];
        for (std::size_t i = 0; i < n; ++i) field[i][elements[node]] += other[i];
        continue;
      }
      std::array<Real, n> sum{};
      for (const std::uint32_t entry : shared_.copies(b, node))
        for (std::size_t i = 0; i < n; ++i) sum[i] += outbox[entry][i];
      for (std::size_t i = 0; i < n; ++i) field[i][elements[node]] = sum[i];
    }
  }

  void move_supports(std::size_t b, const StepTo& step) {
    const BlockArrays<Real>& arrays = states_[b].arrays();
    for (const auto& [motion, component, elements, points] : held_[b]) {
      const AffineDisplacement &before = step.motions_before[motion],
                               &now = step.motions[motion];
      Real* const displacement = arrays.displacement[component];
      Real* const velocity = arrays.velocity[component];
      // Displacement and velocity of the n-th element; where the plate does not turn, of
      // all of them.
      const auto at_point = [&](std::size_t n) {
        const double to = now.component(points[n], component),
                     from = before.component(points[n], component);
        return std::pair(static_cast<Real>(to), static_cast<Real>((to - from) / step.dt));
      };
      if (now.is_equal_everywhere(component) && before.is_equal_everywhere(component)) {
        const auto [u, v] = at_point(0);
        for (const std::uint32_t at : elements) {
          displacement[at] = u;
          velocity[at] = v;
        }
        continue;
      }
      for (std::size_t n = 0; n < elements.size(); ++n)
        std::tie(displacement[elements[n]], velocity[elements[n]]) = at_point(n);
    }
  }

  std::size_t node_count_;  // of the mesh
  std::vector<Block> blocks_;
  BlockForces<Real> block_forces_;
  Integrator integrator_;
  NodalUpdate<Real> update_;
  Workers workers_;
  std::vector<std::vector<Held>> held_;
  SharedNodes shared_;
  std::vector<BlockState<Real>> states_;
  // Forces of the blocks on the nodes they share, of this step and for the next in turn:
  std::array<Outbox<3>, 2> outbox_;
  int parity_ = 0;
  Outbox<1> sums_outbox_;
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
