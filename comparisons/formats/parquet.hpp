#pragma once

#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace springcheck {

/// A column of texts (UTF-8) or numbers, all of one length; an empty text and NaN are
/// nulls.
struct ParquetColumn {
  std::string name;
  std::variant<std::vector<std::string>, std::vector<double>> values;
};

/// Writes a table in the Apache Parquet format: a row group, a data page for each column,
/// plain values without compression, which every reader knows. Debian 12 has no library
/// that writes it. Throws std::runtime_error where a column holds 2 GB or more.
///
/// Source: Apache Parquet's format specification (parquet.thrift, Encodings.md),
/// metadata in Thrift's compact protocol.
void write_parquet(std::ostream& out, const std::vector<ParquetColumn>& columns);

}  // namespace springcheck
