#pragma once

#include <set>
#include <string>
#include <vector>

#include "comparisons/settings/given.hpp"
#include "comparisons/store/columns.hpp"

namespace springcheck::gates {

/// Whether a case without the setting fails the condition. What is said of all gates, or
/// of a gate's own case where it compares with another method's, holds for the settings
/// that the case's method reads.
enum class Absent { fails, passes };

/// What a setting of a case must be: one of several values, each of as many numbers as
/// the column is wide.
struct Condition {
  std::string column, place;  // "gates.toml:4:12: nu"
  std::vector<std::vector<Given::Scalar>> values{};
  // [4, 4, 4] is one value of a column three wide, but three of one that is not:
  bool is_flat_list;
  Absent absent = Absent::fails;
};

/// Conditions that a case must all meet, by column.
using Selection = std::vector<Condition>;

/// The conditions of `narrower`, and those of `selection` on other columns.
Selection narrowed(const Selection& selection, const Selection& narrower);

/// The values of a condition on a column of this width.
std::vector<std::vector<Given::Scalar>> values_of(const Condition& condition,
                                                  std::size_t width);

/// "nu = 0.25", "method = 'mss-cf'"
std::string text_of(const Condition& condition);
std::string text_of(const Selection& selection);

/// Rows of the cases that meet all conditions: numbers to a relative 1e-12, texts
/// literally; deformations may be given as "5%" and "45deg". Throws InputError where
/// there is no such column among the cases nor among the settings, and where a number is
/// wanted and a text given.
std::vector<std::size_t> matching(const Columns& cases, const Selection& selection);

/// Two columns' numbers are the same setting.
bool same_number(double a, double b);

/// The cell as text, numbers with commas; empty where the case has none.
std::string cell_text(const Columns& cases, const std::string& column, std::size_t row);

/// Columns of settings in which the cases differ.
std::set<std::string> differences(const Columns& cases,
                                  const std::vector<std::size_t>& rows);

/// The same with their values: "reference (fem-stvk:q2 or none), element (q1 or q2)".
std::string differences_text(const Columns& cases, const std::vector<std::size_t>& rows);

/// Why no case matches, or how the several that do differ, for who wants one.
std::string why_not_one(const Columns& cases, const Selection& selection,
                        const std::vector<std::size_t>& rows);

}  // namespace springcheck::gates
