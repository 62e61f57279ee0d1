#include "comparisons/measures/history.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "comparisons/measures/measures.hpp"

namespace springcheck {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The measure that answers the load, along the whole load all the way.
double answer_along(const CaseSettings& settings, const Measures& measures,
                    double load_fraction) {
  const Measure* const answer = find_measure(entry_of(settings.test).answer);
  if (answer == nullptr) return none;
  const double value = measure_of(measures, answer->name).value_or(none);
  const bool is_reversed =
      answer->traits.along_last_load && acts_backwards(settings, load_fraction);
  return is_reversed ? -value : value;
}

}  // namespace

HistorySample history_sample(const CaseSettings& settings, const Mesh& mesh,
                             const dynamics::Moment& moment) {
  Solution there{};
  there.displacements = moment.displacements;
  there.reactions = moment.reactions;
  there.lever_arms = moment.lever_arms;
  there.load_fraction = moment.load_fraction;
  const Measures measures = measure(settings, mesh, there);
  const Vector3 no_vector = Vector3::Constant(none);
  const Vector3 force = measures.force.value_or(no_vector),
                torque = measures.torque.value_or(no_vector);
  const double deformation =
      settings.deformation ? moment.load_fraction * *settings.deformation : none;
  const Eigen::Matrix3d P =
      measures.mean_stress.value_or(Eigen::Matrix3d::Constant(none));
  return {moment.time,
          moment.load_fraction,
          deformation,
          measures.volume_change.value_or(none),
          force.x(),
          force.y(),
          force.z(),
          torque.x(),
          torque.y(),
          torque.z(),
          moment.kinetic_energy,
          moment.strain_energy,
          P(0, 0),
          P(0, 1),
          P(0, 2),
          P(1, 0),
          P(1, 1),
          P(1, 2),
          P(2, 0),
          P(2, 1),
          P(2, 2),
          answer_along(settings, measures, moment.load_fraction)};
}

void keep_frame(HistoryFrames& frames, std::size_t sample,
                const std::vector<Vector3>& displacements) {
  constexpr std::size_t most_frames = 24, most_nodes = 500'000;
  const std::size_t apart = frames.size() < 2 ? 1 : frames[1].sample - frames[0].sample;
  if (!frames.empty() && sample < frames.back().sample + apart) return;
  frames.push_back({.sample = sample, .displacements = displacements});
  const std::size_t most = std::clamp<std::size_t>(
      most_nodes / std::max<std::size_t>(1, displacements.size()), 2, most_frames);
  if (frames.size() <= most) return;
  HistoryFrames kept;
  for (std::size_t i = 0; i < frames.size(); i += 2) kept.push_back(std::move(frames[i]));
  frames = std::move(kept);
}

JoinedFrames joined_frames(const HistoryFrames& frames) {
  JoinedFrames joined;
  for (const HistoryFrame& frame : frames) {
    joined.samples.push_back(static_cast<double>(frame.sample));
    joined.displacements.insert(joined.displacements.end(), frame.displacements.begin(),
                                frame.displacements.end());
  }
  return joined;
}

}  // namespace springcheck
