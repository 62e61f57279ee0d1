#pragma once

#include <optional>
#include <string>

#include "comparisons/store/columns.hpp"

namespace springcheck::gates {

/// A column of numbers, or one of its components: x, y, z of vectors, xx, xy, ... of
/// matrices.
struct MeasureColumn {
  std::string name;  // "force.z"
  std::string column;
  std::size_t component;
};

/// "force.z". `place` is for messages. Throws InputError where the cases have no such
/// column and no measure is called so, and where a component is missing or is none.
MeasureColumn measure_column(const std::string& name, const Columns& cases,
                             const std::string& place);

/// The case's value; none where it was not computed or is not finite.
std::optional<double> value_of(const MeasureColumn& measure, const Columns& cases,
                               std::size_t row);

/// A time that the machine took: comparable within one session of one machine only.
bool is_time(const MeasureColumn& measure);

}  // namespace springcheck::gates
