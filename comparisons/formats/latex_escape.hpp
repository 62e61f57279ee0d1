#pragma once

#include <string>
#include <string_view>

namespace springcheck {

/// UTF-8 text as pdfLaTeX prints it: its special characters escaped, `code` in typewriter
/// letters, double quotes opening or closing by what is before them, "+-" as plus or
/// minus. Of other letters those of U+00C0 to U+017F stay, which inputenc knows; further
/// ones read U+4E2D, bytes that are no UTF-8 U+FFFD.
std::string latex_escaped(std::string_view text);

}  // namespace springcheck
