#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/study.hpp"

namespace springcheck {

/// Writes `file` in XDMF: one grid per case, which refers to mesh and fields inside the
/// HDF5 file named `data` in the same folder. Cases without fields are left out.
void write_xdmf(const std::filesystem::path& file, const std::string& data,
                const std::vector<CaseResult>& results, MeshStore& meshes);

}  // namespace springcheck
