#pragma once

#include <filesystem>

namespace springcheck {

/// Throws InputError where there is no Python.
void check_python();

/// Runs the Python program of reports/, which this program contains: it makes page,
/// figures and 3D files of a result file and of the tables and data in the folder.
/// Returns its exit status, see run_program.
int run_report_program(const std::filesystem::path& file,
                       const std::filesystem::path& folder);

}  // namespace springcheck
