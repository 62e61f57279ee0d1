#pragma once

#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// A figure printed in Golec 2018; units and origin in comparisons/shipped/printed.csv.
struct PrintedFigure {
  Test test;
  std::string method;  // "mss-cf", or "fem" for the LS-DYNA column
  double nu;
  double deformation;  // strain, [rad] in torsion
  double value;
  std::string text;     // the value as printed, with its digits
  std::string verdict;  // on instabilities: "yes", "no", or "" where none is printed
  // Names of footnotes, see table_notes::text: of all rows made of the figure, or of
  // those of one method, "mss-stvk:st-venants-volume"; and of a row of the E-forms.
  std::vector<std::string> notes;
  std::string e_form_note;
};

/// The figures of one table, in printed order.
std::vector<PrintedFigure> printed_figures(const std::string& table);

}  // namespace springcheck
