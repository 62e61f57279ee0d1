#pragma once

#include <hdf5.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshing/basics/vector3.hpp"

namespace springcheck::hdf5 {

/// An HDF5 identifier, closed by the function it came with.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) {
    other.id_ = -1;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: as the C functions take it

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// All of these throw std::runtime_error with the object's name when HDF5 fails.
Handle open_file(const std::filesystem::path& file);  // for reading
Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);
Handle group_made_in(hid_t parent, const std::string& name);  // unless it is there
bool has_link(hid_t parent, const std::string& name);
std::vector<std::string> links(hid_t parent);
/// Throws where an object claims more bytes than the file can hold, before anybody
/// reserves memory for them: what was never written (fill values) may be up to a thousand
/// times as large as the file.
void check_size(hid_t object, const std::string& name, double bytes);
/// Copies an object with all it holds into a group of this or another file.
void copy_link(hid_t from, hid_t to, const std::string& name);
void remove_link(hid_t parent, const std::string& name);  // if it is there

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name,
                     std::span<const double> values);
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, long long value);
std::optional<std::string> read_text(hid_t object, const std::string& name);
std::optional<std::vector<double>> read_numbers(hid_t object, const std::string& name);

/// Row-major table of `columns` columns.
void write_table(hid_t parent, const std::string& name, std::span<const double> values,
                 hsize_t columns);
void write_table(hid_t parent, const std::string& name,
                 std::span<const std::uint32_t> values, hsize_t columns);
/// A row of 3 for each vector.
void write_table(hid_t parent, const std::string& name, std::span<const Vector3> vectors);

std::size_t row_count_of_table(hid_t parent, const std::string& name);

/// A table's numbers, row by row; none where there is no such table.
std::optional<std::vector<double>> read_table(hid_t parent, const std::string& name);

}  // namespace springcheck::hdf5
