#pragma once

namespace springcheck {

/// How a table is written.
enum class TableFormat { markdown, csv, json, latex };

}  // namespace springcheck
