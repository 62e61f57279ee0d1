#include "comparisons/store/hdf5.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "meshing/basics/text.hpp"

namespace springcheck::hdf5 {
namespace {

void check(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error("HDF5: " + what + " failed");
}

void write_numbers(hid_t object, const std::string& name, hid_t type, hid_t space,
                   const void* values) {
  const Handle attribute(
      H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "attribute " + name);
  check(H5Awrite(attribute, type, values), "writing attribute " + name);
}

void write_any_table(hid_t parent, const std::string& name, hid_t type,
                     const void* values, hsize_t count, hsize_t columns) {
  const std::array<hsize_t, 2> shape{count / columns, columns};
  const Handle space(H5Screate_simple(columns == 1 ? 1 : 2, shape.data(), nullptr),
                     H5Sclose, name);
  const Handle table(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT,
                                H5P_DEFAULT, H5P_DEFAULT),
                     H5Dclose, "dataset " + name);
  check(H5Dwrite(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
        "writing dataset " + name);
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type, H5T_VARIABLE), "text size");  // h5py reads these as str
  check(H5Tset_cset(type, H5T_CSET_UTF8), "text encoding");
  return type;
}

}  // namespace

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what)
    : id_(id), close_(close) {
  if (id < 0) throw std::runtime_error("HDF5: cannot open or create " + what);
}

Handle open_file(const std::filesystem::path& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, file.string()};
}

void check_size(hid_t object, const std::string& name, double bytes) {
  constexpr double most_of_file = 1000;
  const Handle file(H5Iget_file_id(object), H5Fclose, "the file of " + name);
  hsize_t size = 0;
  check(H5Fget_filesize(file, &size), "sizing the file of " + name);
  if (bytes > most_of_file * static_cast<double>(size))
    throw std::runtime_error(
        fmt::format("HDF5: {} claims {:.3g} bytes in a file of {}", name, bytes, size));
}

Handle create_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
          H5Gclose, "group " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "group " + name};
}

Handle group_made_in(hid_t parent, const std::string& name) {
  return has_link(parent, name) ? open_group(parent, name) : create_group(parent, name);
}

bool has_link(hid_t parent, const std::string& name) {
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> links(hid_t parent) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  check(H5Literate(parent, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names),
        "listing a group");
  return names;
}

void copy_link(hid_t from, hid_t to, const std::string& name) {
  {
    const Handle object(H5Oopen(from, name.c_str(), H5P_DEFAULT), H5Oclose, name);
    constexpr int most = 8;  // beyond, HDF5 1.10 calls a null pointer to copy texts
    if (const int count = H5Aget_num_attrs(object); count > most)
      throw std::runtime_error(
          fmt::format("HDF5: {} has {} attributes, more than {}", name, count, most));
  }
  check(H5Ocopy(from, name.c_str(), to, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        "copying " + name);
}

void remove_link(hid_t parent, const std::string& name) {
  if (has_link(parent, name))
    check(H5Ldelete(parent, name.c_str(), H5P_DEFAULT), "removing " + name);
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const char* characters = text.c_str();
  write_numbers(object, name, text_type(), space, &characters);
}

void write_attribute(hid_t object, const std::string& name,
                     std::span<const double> values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, name);
  write_numbers(object, name, H5T_NATIVE_DOUBLE, space, values.data());
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  write_numbers(object, name, H5T_NATIVE_DOUBLE, space, &value);
}

void write_attribute(hid_t object, const std::string& name, long long value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  write_numbers(object, name, H5T_NATIVE_LLONG, space, &value);
}

std::optional<std::string> read_text(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                         "attribute " + name);
  const Handle type(H5Aget_type(attribute), H5Tclose, "type of " + name),
      space(H5Aget_space(attribute), H5Sclose, "shape of " + name);
  // Several texts would be written behind the pointer to one.
  if (H5Tis_variable_str(type) <= 0 || H5Sget_simple_extent_npoints(space) != 1)
    throw std::runtime_error("HDF5: attribute " + name + " is not one text");
  char* characters = nullptr;
  check(H5Aread(attribute, text_type(), &characters), "reading attribute " + name);
  std::string text(characters == nullptr ? "" : characters);
  check(H5free_memory(characters), "freeing text");
  if (!is_utf8(text))
    throw std::runtime_error("HDF5: attribute " + name + " is not UTF-8");
  return text;
}

std::optional<std::vector<double>> read_numbers(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                         "attribute " + name);
  const Handle space(H5Aget_space(attribute), H5Sclose, "shape of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (count < 0) throw std::runtime_error("HDF5: attribute " + name + " has no size");
  check_size(object, name, static_cast<double>(count) * sizeof(double));
  std::vector<double> values(static_cast<std::size_t>(count));
  check(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()),
        "reading attribute " + name);
  return values;
}

void write_table(hid_t parent, const std::string& name, std::span<const double> values,
                 hsize_t columns) {
  write_any_table(parent, name, H5T_NATIVE_DOUBLE, values.data(), values.size(), columns);
}

void write_table(hid_t parent, const std::string& name,
                 std::span<const std::uint32_t> values, hsize_t columns) {
  write_any_table(parent, name, H5T_NATIVE_UINT32, values.data(), values.size(), columns);
}

void write_table(hid_t parent, const std::string& name,
                 std::span<const Vector3> vectors) {
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Vector3& v : vectors) values.insert(values.end(), v.begin(), v.end());
  write_table(parent, name, values, 3);
}

std::size_t row_count_of_table(hid_t parent, const std::string& name) {
  const Handle table(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose,
                     "table " + name);
  const Handle space(H5Dget_space(table), H5Sclose, "shape of " + name);
  std::array<hsize_t, 2> shape{};
  if (H5Sget_simple_extent_ndims(space) > 2)
    throw std::runtime_error("HDF5: table " + name + " has too many dimensions");
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "sizing table " + name);
  return shape[0];
}

std::optional<std::vector<double>> read_table(hid_t parent, const std::string& name) {
  if (!has_link(parent, name)) return std::nullopt;
  const Handle table(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose,
                     "table " + name);
  const Handle space(H5Dget_space(table), H5Sclose, "shape of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (count < 0) throw std::runtime_error("HDF5: table " + name + " has no size");
  check_size(parent, name, static_cast<double>(count) * sizeof(double));
  std::vector<double> values(static_cast<std::size_t>(count));
  check(H5Dread(table, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "reading table " + name);
  return values;
}

}  // namespace springcheck::hdf5
