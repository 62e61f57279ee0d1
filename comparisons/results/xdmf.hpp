#pragma once

#include <hdf5.h>

#include <filesystem>

namespace springcheck {

/// Writes `file` in XDMF: one grid per case that has fields in the open result file
/// `root`, named `data` and in the same folder.
void write_xdmf(const std::filesystem::path& file, const std::string& data, hid_t root);

}  // namespace springcheck
