#pragma once

#include <string>

#include "comparisons/formats/text_table.hpp"

namespace springcheck {

/// The table as floats for a LaTeX document that loads booktabs and adjustbox: columns of
/// numbers to the right, marks of a column "notes" raised, notes below in a smaller
/// size. A page is narrow: columns that say the same in every row become a note, and a
/// column "case" a comment behind each row. What is wider than the page is scaled to it;
/// more than 40 rows become several floats on pages of their own, the notes below the
/// last.
std::string latex_text(const TextLines& table, const TableText& text);

}  // namespace springcheck
