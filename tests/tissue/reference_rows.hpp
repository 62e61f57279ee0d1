#pragma once

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tissue/bipower_law.hpp"

namespace springcheck::tissue {

/// A row of a file in tests/tissue/reference, by the names of its columns.
class ReferenceRow {
 public:
  explicit ReferenceRow(std::map<std::string, std::string> cells)
      : cells_(std::move(cells)) {}

  [[nodiscard]] const std::string& text(const std::string& column) const {
    return cells_.at(column);
  }
  [[nodiscard]] double number(const std::string& column) const {
    return std::stod(text(column));
  }
  [[nodiscard]] BipowerLaw law() const { return law_of_organ(text("organ")); }

 private:
  std::map<std::string, std::string> cells_;
};

inline std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream stream(line + ",");
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

inline std::vector<ReferenceRow> reference_rows(const std::string& name) {
  std::ifstream file(std::string("tests/tissue/reference/") + name);
  BOOST_TEST_REQUIRE(file.is_open(), name << " is missing");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = split_at_commas(line);
  std::vector<ReferenceRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> parts = split_at_commas(line);
    BOOST_TEST_REQUIRE(parts.size() == columns.size(), line);
    std::map<std::string, std::string> cells;
    for (std::size_t i = 0; i < columns.size(); ++i) cells[columns[i]] = parts[i];
    rows.emplace_back(cells);
  }
  return rows;
}

}  // namespace springcheck::tissue
