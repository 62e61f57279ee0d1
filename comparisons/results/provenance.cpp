#include "comparisons/results/provenance.hpp"

#include <array>
#include <ctime>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/system/environment.hpp"
#include "meshing/gmsh/version.hpp"

namespace springcheck {
namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text.data();
}

std::vector<double> number(int value) {
  return {static_cast<double>(value)};
}

}  // namespace

Row provenance(const std::string& revision) {
  const Environment here = environment();
  return {{"springcheck", std::string(build_info::version)},
          {"commit", std::string(build_info::commit)},
          {"revision", revision.empty() ? build_info::revision : revision},
          {"compiler", here.compiler},
          {"flags", here.flags},
          {"deal.II", std::string(build_info::deal_ii_version)},
          {"gmsh", gmsh_version()},
          {"Eigen", std::string(build_info::eigen_version)},
          {"HDF5", std::string(build_info::hdf5_version)},
          {"BLAS", here.blas},
          {"cpu", here.processor},
          {"machine", here.machine},
          {"clock", here.clock},
          {"instructions", here.instructions},
          {"cores", number(here.cores)},
          {"threads", number(here.threads)},
          {"date", utc_now()}};
}

}  // namespace springcheck
