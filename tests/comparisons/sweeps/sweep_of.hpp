#pragma once

#include <cstddef>
#include <fstream>
#include <string>

#include "comparisons/sweeps/sweep_file.hpp"
#include "tests/own_folder.hpp"

namespace springcheck {

inline Sweep sweep_of(const std::string& text, std::size_t most = 1000) {
  const OwnFolder own;
  std::ofstream(own.path / "sweep.toml") << text;
  return read_sweep((own.path / "sweep.toml").string(), most);
}

}  // namespace springcheck
