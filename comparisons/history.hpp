#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "comparisons/case.hpp"
#include "dynamics/march.hpp"

namespace springcheck {

/// A moment of a case in dynamics, in the order of history_columns: time [s], load
/// fraction, deformation (no number in tests without one), volume change (V - V0)/V0,
/// force [N] and torque [N m] on the moved plate (no numbers without one), kinetic and
/// strain energy [J].
using HistorySample = std::array<double, 12>;
using History = std::vector<HistorySample>;

inline constexpr std::array<std::string_view, 12> history_columns{
    "time",     "load_fraction", "deformation",    "volume_change",
    "force_x",  "force_y",       "force_z",        "torque_x",
    "torque_y", "torque_z",      "kinetic_energy", "strain_energy"};

HistorySample history_sample(const CaseSettings& settings, const Mesh& mesh,
                             const dynamics::Moment& moment);

}  // namespace springcheck
