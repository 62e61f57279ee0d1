#pragma once

#include <cstdint>
#include <vector>

#include "comparisons/sweeps/sweep_file.hpp"

namespace springcheck {

/// A case of a sweep, of which there may be a million: where it is asked for first.
struct PlannedCase {
  std::uint32_t combination;  // of the sweep
  std::uint32_t request;      // among those of the combination
};

Request request_of(const Sweep& sweep, const PlannedCase& planned);

/// Part `shard` (from 1) of `shards` of the cases, each once; those of one reference
/// follow each other. Throws InputError, before anything runs, for combinations that no
/// test allows, meshes of files that cannot be read, and bodies that would not fit into
/// the memory.
std::vector<PlannedCase> planned_cases(const Sweep& sweep, MeshHashes& meshes, int shard,
                                       int shards);

}  // namespace springcheck
