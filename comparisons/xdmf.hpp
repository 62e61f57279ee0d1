#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/study.hpp"

namespace springcheck {

/// Writes FILE.xdmf beside the result file FILE.h5: one grid per case, which refers to
/// mesh and fields inside the HDF5 file. Cases without fields are left out.
void write_xdmf(const std::filesystem::path& result_file,
                const std::vector<CaseResult>& results, MeshStore& meshes);

}  // namespace springcheck
