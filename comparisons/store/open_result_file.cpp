#include "comparisons/store/open_result_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <chrono>
#include <exception>
#include <new>
#include <thread>

#include "comparisons/store/journal.hpp"
#include "comparisons/store/lock_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {

hdf5::Handle open_result_file(const std::filesystem::path& file) {
  auto root = hdf5::open_file(file);
  const auto found = hdf5::read_numbers(root, "layout");
  if (!found)
    throw InputError(file.string(), "", "a springcheck result file",
                     "an HDF5 file without a layout number");
  if (found->size() != 1 || found->front() != static_cast<double>(result_layout))
    throw InputError(file.string(), "layout", std::to_string(result_layout),
                     fmt::format("{:g}", fmt::join(*found, ", ")));
  return root;
}

void settle(const std::filesystem::path& file) {
  using namespace std::chrono_literals;
  for (auto waited = 0ms; std::filesystem::exists(journal_of(file)); waited += 10ms) {
    try {
      const LockFile lock(file);
      recover(file);
      return;
    } catch (const InputError&) {
      if (waited > 10s) throw;  // its writer hangs, or the folder cannot be written
    }
    std::this_thread::sleep_for(10ms);
  }
}

std::pair<std::filesystem::file_time_type, std::uintmax_t> state_of(
    const std::filesystem::path& file) {
  return {std::filesystem::last_write_time(file), std::filesystem::file_size(file)};
}

bool is_unchanged(
    const std::filesystem::path& file,
    const std::pair<std::filesystem::file_time_type, std::uintmax_t>& state) {
  return state_of(file) == state && !std::filesystem::exists(journal_of(file));
}

void refuse_as_unreadable(const std::filesystem::path& file) {
  try {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {  // says nothing about the file
    throw;
  } catch (const std::exception& error) {
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (opened >= 0) H5Fclose(opened);
    const std::string got = opened >= 0 ? error.what()
                            : H5Fis_hdf5(file.c_str()) <= 0
                                ? "what is no HDF5 file, or one that was cut off"
                                : "one that was cut off, or that HDF5 cannot open";
    throw InputError(file.string(), "", "a readable springcheck result file", got);
  }
}

void refuse_as_changing(const std::filesystem::path& file) {
  throw InputError(file.string(), "", "a file that stays as it is while it is read",
                   "one that is changed again and again");
}

std::filesystem::path existing_result_file(const std::filesystem::path& name) {
  std::filesystem::path file = link_target(name);
  if (!std::filesystem::exists(file))
    throw InputError(name.string(), "", "a result file", "no such file");
  return file;
}

}  // namespace springcheck
