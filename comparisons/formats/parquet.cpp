#include "comparisons/formats/parquet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace springcheck {
namespace {

static_assert(std::endian::native == std::endian::little);  // as values are stored

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

/// Values of enumerations in parquet.thrift.
enum Type { real = 5, byte_array = 6 };
enum Encoding { plain = 0, run_lengths = 3 };
constexpr int data_page = 0, uncompressed = 0, optional = 1, utf8 = 0;

constexpr std::string_view parquet_magic = "PAR1";

/// The number in seven bits a byte, the lowest first.
std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  return bytes + static_cast<char>(value);
}

template <class Number>
std::string raw(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// A struct in Thrift's compact protocol; fields are added in ascending order.
class Struct {
 public:
  Struct& number(int id, std::int64_t value) { return field(id, i32, zigzag(value)); }
  Struct& long_number(int id, std::int64_t value) {
    return field(id, i64, zigzag(value));
  }
  Struct& text(int id, std::string_view value) { return field(id, binary, sized(value)); }
  Struct& structure(int id, const Struct& value) {
    return field(id, structured, value.bytes());
  }
  Struct& structures(int id, const std::vector<Struct>& values) {
    std::string bytes;
    for (const Struct& value : values) bytes += value.bytes();
    return list(id, structured, values.size(), bytes);
  }
  Struct& numbers(int id, const std::vector<int>& values) {
    std::string bytes;
    for (const int value : values) bytes += zigzag(value);
    return list(id, i32, values.size(), bytes);
  }
  Struct& texts(int id, const Texts& values) {
    std::string bytes;
    for (const std::string& value : values) bytes += sized(value);
    return list(id, binary, values.size(), bytes);
  }

  [[nodiscard]] std::string bytes() const { return fields_ + '\0'; }

 private:
  enum Kind { i32 = 5, i64 = 6, binary = 8, listed = 9, structured = 12 };

  static std::string zigzag(std::int64_t value) {
    return varint(static_cast<std::uint64_t>(value) << 1 ^
                  static_cast<std::uint64_t>(value >> 63));
  }
  static std::string sized(std::string_view text) { return varint(text.size()) += text; }

  Struct& field(int id, Kind kind, const std::string& bytes) {
    fields_ += static_cast<char>((id - last_) << 4 | kind);  // steps are below 16
    fields_ += bytes;
    last_ = id;
    return *this;
  }
  Struct& list(int id, Kind of, std::size_t size, const std::string& bytes) {
    constexpr std::size_t most_in_head = 14;
    const auto head = static_cast<char>(std::min(size, most_in_head + 1) << 4 |
                                        static_cast<std::size_t>(of));
    return field(id, listed,
                 head + (size > most_in_head ? varint(size) : std::string()) + bytes);
  }

  std::string fields_;
  int last_ = 0;
};

bool is_null(const std::string& text) {
  return text.empty();
}
bool is_null(double number) {
  return std::isnan(number);
}
std::string plain_value(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) += text;
}
std::string plain_value(double number) {
  return raw(number);
}

/// The content of a page: runs that tell which values are there, then those values.
template <class Value>
std::string page_of(const std::vector<Value>& values) {
  std::string levels, present;
  for (std::size_t i = 0; i < values.size();) {
    const bool is_there = !is_null(values[i]);
    const std::size_t first = i;
    for (; i < values.size() && is_null(values[i]) != is_there; ++i)
      if (is_there) present += plain_value(values[i]);
    levels += varint((i - first) << 1) += static_cast<char>(is_there);
  }
  return raw(static_cast<std::uint32_t>(levels.size())) + levels + present;
}

/// Head and values of a column's only page.
struct DataPage {
  std::string head, values;
  [[nodiscard]] std::size_t size() const { return head.size() + values.size(); }
};

DataPage page_of(const ParquetColumn& column, std::size_t rows) {
  DataPage page{
      .head = {},
      .values = std::visit([](const auto& all) { return page_of(all); }, column.values)};
  if (page.values.size() > std::numeric_limits<std::int32_t>::max())
    throw std::runtime_error("the column '" + column.name + "' is too large for Parquet");
  const auto size = static_cast<std::int64_t>(page.values.size());
  page.head = Struct()
                  .number(1, data_page)
                  .number(2, size)
                  .number(3, size)
                  .structure(5, Struct()
                                    .number(1, static_cast<std::int64_t>(rows))
                                    .number(2, plain)
                                    .number(3, run_lengths)
                                    .number(4, run_lengths))
                  .bytes();
  return page;
}

Type type_of(const ParquetColumn& column) {
  return std::holds_alternative<Texts>(column.values) ? byte_array : real;
}

Struct schema_of(const ParquetColumn& column) {
  Struct schema;
  schema.number(1, type_of(column)).number(3, optional).text(4, column.name);
  if (type_of(column) == byte_array)
    schema.number(6, utf8).structure(10, Struct().structure(1, Struct()));
  return schema;
}

Struct chunk_of(const ParquetColumn& column, const DataPage& page, std::int64_t place,
                std::int64_t rows) {
  const auto size = static_cast<std::int64_t>(page.size());
  return Struct().long_number(2, place).structure(3, Struct()
                                                         .number(1, type_of(column))
                                                         .numbers(2, {plain, run_lengths})
                                                         .texts(3, {column.name})
                                                         .number(4, uncompressed)
                                                         .long_number(5, rows)
                                                         .long_number(6, size)
                                                         .long_number(7, size)
                                                         .long_number(9, place));
}

std::size_t rows_of(const std::vector<ParquetColumn>& columns) {
  if (columns.empty()) return 0;
  return std::visit([](const auto& all) { return all.size(); }, columns.front().values);
}

}  // namespace

void write_parquet(std::ostream& out, const std::vector<ParquetColumn>& columns) {
  const std::size_t rows = rows_of(columns);
  const auto row_count = static_cast<std::int64_t>(rows);
  std::vector<Struct> schema{
      Struct().text(4, "cases").number(5, static_cast<std::int64_t>(columns.size()))};
  std::vector<Struct> chunks;
  out << parquet_magic;
  auto place = static_cast<std::int64_t>(parquet_magic.size());
  std::int64_t size = 0;
  for (const ParquetColumn& column : columns) {
    schema.push_back(schema_of(column));
    if (rows == 0) continue;
    const DataPage page = page_of(column, rows);
    out << page.head << page.values;
    chunks.push_back(chunk_of(column, page, place + size, row_count));
    size += static_cast<std::int64_t>(page.size());
  }
  std::vector<Struct> groups;
  if (rows > 0)
    groups.push_back(
        Struct().structures(1, chunks).long_number(2, size).long_number(3, row_count));
  const std::string footer = Struct()
                                 .number(1, 1)
                                 .structures(2, schema)
                                 .long_number(3, row_count)
                                 .structures(4, groups)
                                 .text(6, "springcheck")
                                 .bytes();
  out << footer << raw(static_cast<std::uint32_t>(footer.size())) << parquet_magic;
}

}  // namespace springcheck
