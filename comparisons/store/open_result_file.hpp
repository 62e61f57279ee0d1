#pragma once

#include <filesystem>
#include <utility>

#include "comparisons/store/hdf5.hpp"

namespace springcheck {

/// Number of the layout that result_file.hpp documents.
inline constexpr long long result_layout = 2;

/// The root of a result file, for reading. Throws InputError for a file of another
/// layout, and std::runtime_error for one that is no HDF5.
hdf5::Handle open_result_file(const std::filesystem::path& file);

/// Waits for a living writer to finish its journal; a dead one's is finished here.
void settle(const std::filesystem::path& file);

/// When a file was changed, and its size.
std::pair<std::filesystem::file_time_type, std::uintmax_t> state_of(
    const std::filesystem::path& file);

/// Whether the file is still in that state, and no change is under way.
bool is_unchanged(
    const std::filesystem::path& file,
    const std::pair<std::filesystem::file_time_type, std::uintmax_t>& state);

/// Throws InputError for the file with what went wrong, the exception being handled.
[[noreturn]] void refuse_as_unreadable(const std::filesystem::path& file);

/// The file behind a name. Throws InputError where there is none.
std::filesystem::path existing_result_file(const std::filesystem::path& name);

/// read(root) of a result file; whatever is wrong with the file is an InputError.
template <class Read>
auto read_once(const std::filesystem::path& file, Read&& read) {
  try {
    const auto root = open_result_file(file);
    return read(root);
  } catch (...) {
    refuse_as_unreadable(file);
  }
}

/// Throws InputError for a file that is changed again and again while it is read.
[[noreturn]] void refuse_as_changing(const std::filesystem::path& file);

/// read_once of a file that nobody changes meanwhile: what was seen in between is not
/// believed. `read` may be called again.
template <class Read>
auto reading(const std::filesystem::path& name, Read&& read) {
  constexpr int attempts = 100;
  const std::filesystem::path file = existing_result_file(name);
  for (int attempt = 1;; ++attempt) {
    settle(file);
    const auto before = state_of(file);
    try {
      auto found = read_once(file, read);
      if (is_unchanged(file, before)) return found;
    } catch (...) {
      if (is_unchanged(file, before)) throw;
    }
    if (attempt == attempts) refuse_as_changing(file);
  }
}

}  // namespace springcheck
