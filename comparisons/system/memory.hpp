#pragma once

#include <filesystem>

namespace springcheck {

/// What this process may still take [bytes]: the least of what the machine has left, as
/// Linux estimates it, of what the process's control groups (of containers and batch
/// systems) have left, and of what is left of its address space (ulimit -v). Infinite
/// where nothing is known.
double available_memory();

/// The part of control groups, versions 1 and 2: limit less use, but for cached files,
/// of each group above. As files below `root` tell it, which is / but for tests.
double room_of_control_groups(const std::filesystem::path& root);

/// The part of the address space.
double room_of_address_space();

/// What this process has of the machine's memory, and the most since the last reset
/// [bytes], as Linux counts it; 0 elsewhere.
double resident_memory();
double peak_memory();
void reset_peak_memory();

}  // namespace springcheck
