#include "comparisons/tables/tissue/sheared_tissue.hpp"

#include <array>

namespace springcheck {

CaseSettings sheared_tissue(std::string_view organ, double rate, double strain) {
  return case_of_scene("tissue-shearing",
                       {{"organ", organ},
                        {"rate", rate},
                        {"gradient", std::array<double, 9>{0, 0, strain}},
                        {"cells", std::array{2, 2, 2}},
                        {"time-steps", 100}});
}

}  // namespace springcheck
