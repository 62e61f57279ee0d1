#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "dynamics/marching/march.hpp"

namespace springcheck {

/// A moment of a case in dynamics, in the order of history_columns: time [s], load
/// fraction, deformation (no number in tests without one), volume change (V - V0)/V0,
/// force [N] and torque [N m] on the moved plate (no numbers without one), kinetic and
/// strain energy [J], the measure mean_stress [Pa] (no numbers but in affine), the
/// measure that answers the test's load (of a vector its length; no number in affine),
/// along the whole load wherever the path has gone.
inline constexpr std::array<std::string_view, 22> history_columns{
    "time",           "load_fraction", "deformation", "volume_change", "force_x",
    "force_y",        "force_z",       "torque_x",    "torque_y",      "torque_z",
    "kinetic_energy", "strain_energy", "stress_xx",   "stress_xy",     "stress_xz",
    "stress_yx",      "stress_yy",     "stress_yz",   "stress_zx",     "stress_zy",
    "stress_zz",      "answer"};
using HistorySample = std::array<double, history_columns.size()>;
using History = std::vector<HistorySample>;

/// The body at a sample of the history: displacements [m] of all nodes.
struct HistoryFrame {
  std::size_t sample;
  std::vector<Vector3> displacements;
};
using HistoryFrames = std::vector<HistoryFrame>;

/// Keeps the sample as a frame where it is one of those that are kept: the first, and
/// others evenly apart. Once there are more than 24 of them, or more than 500,000 nodes
/// in all of them (but two are always kept), every other one goes, and of those to come
/// every other one is kept.
void keep_frame(HistoryFrames& frames, std::size_t sample,
                const std::vector<Vector3>& displacements);

/// Force, torque and stress are those of the load at that moment.
HistorySample history_sample(const CaseSettings& settings, const Mesh& mesh,
                             const dynamics::Moment& moment);

/// Frames as files have them, one after the other.
struct JoinedFrames {
  std::vector<double> samples;
  std::vector<Vector3> displacements;
};
JoinedFrames joined_frames(const HistoryFrames& frames);

}  // namespace springcheck
