#pragma once

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Figures that the second program in this folder computes, figures.py. How near the first
// must come is each test's own matter: both solve the same equations, to 1e-8 and below.
namespace referee {

/// A row of a file of figures, by the names of its columns.
class Row {
 public:
  explicit Row(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}

  [[nodiscard]] const std::string& text(const std::string& column) const {
    return cells_.at(column);
  }
  [[nodiscard]] double number(const std::string& column) const {
    return std::stod(text(column));
  }

 private:
  std::map<std::string, std::string> cells_;
};

inline std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream stream(line + ",");
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

inline std::vector<Row> rows_of(const std::string& path) {
  std::ifstream file(path);
  BOOST_TEST_REQUIRE(file.is_open(), path << " is missing");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = split_at_commas(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> parts = split_at_commas(line);
    BOOST_TEST_REQUIRE(parts.size() == columns.size(), line);
    std::map<std::string, std::string> cells;
    for (std::size_t i = 0; i < columns.size(); ++i) cells[columns[i]] = parts[i];
    rows.emplace_back(std::move(cells));
  }
  return rows;
}

/// The rows of tests/referee/figures/TOPIC.csv.
inline std::vector<Row> rows(const std::string& topic) {
  return rows_of("tests/referee/figures/" + topic + ".csv");
}

/// A figure of a topic whose columns are case, quantity and value.
inline double figure(const std::string& topic, const std::string& of_case,
                     const std::string& quantity) {
  std::vector<double> found;
  for (const Row& row : rows(topic))
    if (row.text("case") == of_case && row.text("quantity") == quantity)
      found.push_back(row.number("value"));
  BOOST_TEST_REQUIRE(found.size() == 1U, topic << ".csv: " << quantity << " of "
                                               << of_case << ", expected one, got "
                                               << found.size());
  return found.front();
}

}  // namespace referee
