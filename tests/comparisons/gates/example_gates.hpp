#pragma once

#include <limits>
#include <string>
#include <vector>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "comparisons/store/columns.hpp"

namespace springcheck::gates {

/// A result file's table as it would be read: nu .1 to .4 of mss-cf, and finite elements
/// at nu .25 on three grids, whose forces 1 + h^2 converge with order 2.
inline Columns table() {
  constexpr double null = std::numeric_limits<double>::quiet_NaN();
  Columns cases;
  cases.rows = 7;
  cases.texts["key"] = {"a", "b", "c", "d", "e", "f", "g"};
  cases.texts["scene"] = std::vector<std::string>(7, "compression");
  cases.texts["method"] = {"mss-cf", "mss-cf", "mss-cf", "mss-nfd", "fem", "fem", "fem"};
  cases.texts["element"] = {"", "", "", "", "q1", "q1", "q1"};
  cases.texts["status"] = {"ok", "ok", "ok", "wrinkled", "ok", "ok", "ok"};
  cases.texts["reason"] = {"", "", "", "a free face zigzags", "", "", ""};
  cases.numbers["nu"] = {1, {0.1, 0.25, 0.4, 0.25, 0.25, 0.25, 0.25}};
  cases.numbers["deformation"] = {1, std::vector<double>(7, 0.05)};
  cases.numbers["cells"] = {
      3, {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2, 2, 4, 4, 4, 8, 8, 8}};
  cases.numbers["volume_error"] = {1, {0.043, 0.032, null, 0.033, 0.03, 0.03, 0.03}};
  cases.numbers["plate_force"] = {1, {1.2, 1.3, 1.5, 1.1, 1.25, 1.0625, 1.015625}};
  cases.numbers["force"] = {
      3, {0, 0, -1.2, 0, 0, -1.3, 0, 0, -1.5, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1}};
  cases.numbers["solve_wall_s"] = {1, {1, 2, 3, 4, 5, 8, 7}};
  cases.numbers["provenance"] = {1, {0, 0, 1, 0, 0, 0, 0}};
  return cases;
}

inline const std::string head = "[[gate]]\nname = 'g'\nreason = 'r'\n";
inline const std::string cf = "where = { method = 'mss-cf', nu = 0.25 }\n";
inline const std::string force = cf + "measure = 'plate_force'\n";
inline const std::string null_case = "where = { method = 'mss-cf', nu = 0.4 }\n";

inline Outcome outcome_of(const std::string& gate, const Columns& cases = table()) {
  return check(parse_gates(head + gate, "gates.toml").front(), cases, "file.h5");
}

}  // namespace springcheck::gates
