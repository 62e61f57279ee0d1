#pragma once

#include <string>

#include "meshing/basics/input_error.hpp"

namespace springcheck::tissue {

/// The message of the InputError that `work` ends in, "none" without.
template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace springcheck::tissue
