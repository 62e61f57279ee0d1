#pragma once

#include <hdf5.h>

#include <filesystem>
#include <map>
#include <string>

namespace springcheck {

/// Writes `file` in XDMF: one grid for each of the cases that has fields in the open
/// result file `root`, named `data` and in the same folder. `cases`: their keys, and
/// their revisions of the numerics where those are not this program's, which grids' names
/// then tell.
void write_xdmf(const std::filesystem::path& file, const std::string& data, hid_t root,
                const std::map<std::string, std::string>& cases);

}  // namespace springcheck
