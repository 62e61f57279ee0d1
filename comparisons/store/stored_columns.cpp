#include "comparisons/store/stored_columns.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "comparisons/store/hdf5.hpp"
#include "meshing/basics/text.hpp"

namespace springcheck {
namespace {

using hdf5::Handle;

constexpr hsize_t rows_per_chunk = 128;
constexpr std::size_t first_text_width = 32;  // [bytes]

void check(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error("HDF5: " + what + " failed");
}

Handle text_type(std::size_t width) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type, width), "text size");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "text padding");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "text encoding");
  return type;
}

Handle open_column(hid_t group, const std::string& name) {
  return {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "column " + name};
}

/// What a column is made of.
struct Shape {
  bool is_text;
  std::size_t width;  // bytes of texts, or numbers in a row
  hsize_t rows;
};

Shape shape_of(hid_t column, const std::string& name) {
  const Handle type(H5Dget_type(column), H5Tclose, "type of column " + name);
  const Handle space(H5Dget_space(column), H5Sclose, "shape of column " + name);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank != 1 && rank != 2)
    throw std::runtime_error("column " + name + " has neither one nor two dimensions");
  std::array<hsize_t, 2> size{0, 1};
  check(H5Sget_simple_extent_dims(space, size.data(), nullptr), "sizing column " + name);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING && rank == 1 && H5Tis_variable_str(type) == 0)
    return {.is_text = true, .width = H5Tget_size(type), .rows = size[0]};
  if (kind == H5T_FLOAT || kind == H5T_INTEGER)
    return {.is_text = false, .width = size[1], .rows = size[0]};
  throw std::runtime_error("column " + name + " holds neither numbers nor texts");
}

double bytes_of(const Shape& shape) {
  const std::size_t each = shape.is_text ? 1 : sizeof(double);
  return static_cast<double>(shape.rows) * static_cast<double>(shape.width * each);
}

void check_size(hid_t group, const std::string& name, const Shape& shape) {
  hdf5::check_size(group, "column " + name, bytes_of(shape));
}

Handle create_column(hid_t group, const std::string& name, const Shape& shape) {
  const int rank = shape.is_text || shape.width == 1 ? 1 : 2;
  const hsize_t width = shape.is_text ? 1 : shape.width;
  const std::array<hsize_t, 2> size{shape.rows, width}, most{H5S_UNLIMITED, width},
      chunk{rows_per_chunk, width};
  const Handle space(H5Screate_simple(rank, size.data(), most.data()), H5Sclose, name);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  check(H5Pset_chunk(properties, rank, chunk.data()), "chunks of " + name);
  if (shape.is_text)
    return {H5Dcreate2(group, name.c_str(), text_type(shape.width), space, H5P_DEFAULT,
                       properties, H5P_DEFAULT),
            H5Dclose, "column " + name};
  const double missing = std::numeric_limits<double>::quiet_NaN();
  check(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &missing), "filling " + name);
  return {H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties,
                     H5P_DEFAULT),
          H5Dclose, "column " + name};
}

/// The file's and the memory's selection of `count` rows from `first`.
struct Selection {
  Selection(hid_t column, const Shape& shape, hsize_t first, hsize_t count)
      : file(H5Dget_space(column), H5Sclose, "rows"),
        memory(H5Screate_simple(rank(shape), std::array{count, width(shape)}.data(),
                                nullptr),
               H5Sclose, "rows") {
    const std::array<hsize_t, 2> start{first, 0}, size{count, width(shape)};
    check(H5Sselect_hyperslab(file, H5S_SELECT_SET, start.data(), nullptr, size.data(),
                              nullptr),
          "selecting rows");
  }
  static int rank(const Shape& s) { return s.is_text || s.width == 1 ? 1 : 2; }
  static hsize_t width(const Shape& s) { return s.is_text ? 1 : s.width; }
  Handle file, memory;
};

std::string read_text_bytes(hid_t column, const std::string& name, const Shape& shape) {
  std::string bytes(shape.rows * shape.width, '\0');
  check(H5Dread(column, text_type(shape.width), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                bytes.data()),
        "reading column " + name);
  return bytes;
}

std::vector<std::string> split(const std::string& bytes, std::size_t width) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < bytes.size(); at += width) {
    const std::string_view cell = std::string_view(bytes).substr(at, width);
    texts.emplace_back(cell.substr(0, cell.find('\0')));
  }
  return texts;
}

std::vector<std::string> checked_texts(const std::string& bytes, std::size_t width,
                                       const std::string& name) {
  std::vector<std::string> texts = split(bytes, width);
  std::string all;
  for (const std::string& text : texts) all.append(text).push_back('\0');
  if (!is_utf8(all)) throw std::runtime_error("column " + name + " is not UTF-8");
  return texts;
}

std::string padded(const std::vector<std::string>& texts, std::size_t width) {
  std::string bytes;
  for (const std::string& text : texts) {
    bytes += text;
    bytes.resize(bytes.size() + width - text.size(), '\0');
  }
  return bytes;
}

void write_text_bytes(hid_t column, const Shape& shape, hsize_t first,
                      const std::vector<std::string>& texts) {
  const Selection rows(column, shape, first, texts.size());
  check(H5Dwrite(column, text_type(shape.width), rows.memory, rows.file, H5P_DEFAULT,
                 padded(texts, shape.width).data()),
        "writing texts");
}

/// The column with room for longer texts.
Handle widened(hid_t group, const std::string& name, Shape shape, std::size_t width) {
  const std::vector<std::string> texts =
      split(read_text_bytes(open_column(group, name), name, shape), shape.width);
  check(H5Ldelete(group, name.c_str(), H5P_DEFAULT), "replacing column " + name);
  shape.width = std::max(width, 2 * shape.width);
  Handle column = create_column(group, name, shape);
  if (!texts.empty()) write_text_bytes(column, shape, 0, texts);
  return column;
}

/// Row by row.
std::vector<double> numbers_of(hid_t column, hid_t group, const std::string& name) {
  const Shape shape = shape_of(column, name);
  if (shape.is_text) throw std::runtime_error("column " + name + " holds no numbers");
  check_size(group, name, shape);
  std::vector<double> values(shape.rows * shape.width);
  check(H5Dread(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "reading column " + name);
  return values;
}

using Value = Row::mapped_type;

/// The rows' values of one column.
struct NewValues {
  std::size_t width = 0;  // of the longest text, or numbers in a row
  bool is_text = false;
  std::vector<const Value*> values;  // null where a row has none
};

NewValues values_of(std::span<const Row> rows, const std::string& name) {
  NewValues found;
  for (const Row& row : rows) {
    const auto cell = row.find(name);
    found.values.push_back(cell == row.end() ? nullptr : &cell->second);
    if (cell == row.end()) continue;
    found.is_text = std::holds_alternative<std::string>(cell->second);
    found.width = std::max(
        found.width,
        std::visit([](const auto& value) { return value.size(); }, cell->second));
  }
  return found;
}

void write_values(hid_t group, const std::string& name, hsize_t first, hsize_t rows,
                  const NewValues& added) {
  std::optional<Handle> column;
  if (!hdf5::has_link(group, name)) {
    const std::size_t width =
        added.is_text ? std::max(added.width, first_text_width) : added.width;
    column.emplace(create_column(group, name, {added.is_text, width, rows}));
  } else {
    column.emplace(open_column(group, name));
  }
  Shape shape = shape_of(*column, name);
  if (shape.rows < rows) {
    const std::array<hsize_t, 2> size{rows, shape.width};
    check(H5Dset_extent(*column, size.data()), "extending column " + name);
    shape.rows = rows;
  }
  if (added.width == 0 && shape.rows == rows && first + added.values.size() == rows &&
      std::ranges::all_of(added.values, [](const Value* v) { return v == nullptr; }))
    return;  // appended rows without a value: the fill value says so
  if (added.width > 0 && added.is_text != shape.is_text)
    throw std::runtime_error("column " + name + " takes " +
                             (shape.is_text ? "texts" : "numbers") + " only");
  if (shape.is_text) {
    if (added.width > shape.width) {
      column.emplace(widened(group, name, shape, added.width));
      shape = shape_of(*column, name);
    }
    std::vector<std::string> texts;
    for (const Value* value : added.values)
      texts.push_back(value == nullptr ? "" : std::get<std::string>(*value));
    write_text_bytes(*column, shape, first, texts);
    return;
  }
  std::vector<double> numbers;
  for (const Value* value : added.values) {
    if (value == nullptr) {
      numbers.insert(numbers.end(), shape.width,
                     std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const auto& row = std::get<std::vector<double>>(*value);
    if (row.size() != shape.width)
      throw std::runtime_error("column " + name + " takes " +
                               std::to_string(shape.width) + " numbers in a row, not " +
                               std::to_string(row.size()));
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  const Selection place(*column, shape, first, added.values.size());
  check(H5Dwrite(*column, H5T_NATIVE_DOUBLE, place.memory, place.file, H5P_DEFAULT,
                 numbers.data()),
        "writing column " + name);
}

void write_rows(hid_t group, std::size_t first, std::size_t rows_after,
                std::span<const Row> rows) {
  std::vector<std::string> names = hdf5::links(group);
  for (const Row& row : rows)
    for (const auto& [name, value] : row)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  for (const std::string& name : names)
    write_values(group, name, first, rows_after, values_of(rows, name));
}

}  // namespace

std::size_t row_count(hid_t group) {
  const std::vector<std::string> names = hdf5::links(group);
  if (names.empty()) return 0;
  return shape_of(open_column(group, names.front()), names.front()).rows;
}

void append_rows(hid_t group, std::span<const Row> rows) {
  const std::size_t before = row_count(group);
  write_rows(group, before, before + rows.size(), rows);
}

void replace_row(hid_t group, std::size_t index, const Row& row) {
  write_rows(group, index, row_count(group), {&row, 1});
}

std::vector<double> read_number_column(hid_t group, const std::string& name) {
  if (!hdf5::has_link(group, name)) return {};
  return numbers_of(open_column(group, name), group, name);
}

std::vector<std::string> read_texts(hid_t group, const std::string& name) {
  if (!hdf5::has_link(group, name)) return {};
  const Handle column = open_column(group, name);
  const Shape shape = shape_of(column, name);
  if (!shape.is_text) throw std::runtime_error("column " + name + " holds no texts");
  check_size(group, name, shape);
  return checked_texts(read_text_bytes(column, name, shape), shape.width, name);
}

Columns read_columns(hid_t group) {
  Columns table;
  table.rows = row_count(group);
  double bytes = 0;
  for (const std::string& name : hdf5::links(group)) {
    const Handle column = open_column(group, name);
    const Shape shape = shape_of(column, name);
    if (shape.rows != table.rows)
      throw std::runtime_error("column " + name + " has " + std::to_string(shape.rows) +
                               " rows, others " + std::to_string(table.rows));
    bytes += bytes_of(shape);
    hdf5::check_size(group, "a table up to column " + name, bytes);
    if (shape.is_text) {
      table.texts.emplace(
          name, checked_texts(read_text_bytes(column, name, shape), shape.width, name));
      continue;
    }
    table.numbers.emplace(name, NumberColumn{.width = shape.width,
                                             .values = numbers_of(column, group, name)});
  }
  return table;
}

}  // namespace springcheck
