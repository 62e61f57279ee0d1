#pragma once

#include <hdf5.h>

#include "comparisons/store/columns.hpp"

// A table as an HDF5 group holds it: a dataset for each column, all of one length, so
// that h5py and HDFView show it as it is. Columns are texts (UTF-8, padded with zeros) or
// numbers, one or several in a row (of shape rows x width).
namespace springcheck {

/// The number of rows of the table in the group: the length of its columns.
std::size_t row_count(hid_t group);

/// Appends rows, making the columns that are new. The cost does not depend on the rows
/// there are, unless a text is longer than all before in its column, which is then
/// rewritten. Throws std::runtime_error when a value does not fit its column's kind or
/// width.
void append_rows(hid_t group, std::span<const Row> rows);

/// Replaces a row. Columns it lacks become NaN or empty.
void replace_row(hid_t group, std::size_t index, const Row& row);

/// The table of all columns, or one column of texts or numbers, empty where there is
/// none. Throws std::runtime_error when their lengths differ.
Columns read_columns(hid_t group);
std::vector<std::string> read_texts(hid_t group, const std::string& column);
std::vector<double> read_number_column(hid_t group, const std::string& column);

}  // namespace springcheck
