# OUTPUT: C++ source that holds the text of INPUT, see declarations_text.hpp.
file(READ ${INPUT} text)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "comparisons/declarations_text.hpp"

const char* const springcheck::declarations_text = R"--8<--(@text@)--8<--";
]])
