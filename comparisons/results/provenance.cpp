#include "comparisons/results/provenance.hpp"

#include <tbb/global_control.h>

#include <array>
#include <ctime>
#include <thread>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/processor.hpp"
#include "meshing/gmsh/version.hpp"

namespace springcheck {
namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text.data();
}

std::vector<double> number(std::size_t value) {
  return {static_cast<double>(value)};
}

}  // namespace

Row provenance(const std::string& revision) {
  using tbb::global_control;
  return {{"springcheck", std::string(build_info::version)},
          {"commit", std::string(build_info::commit)},
          {"revision", revision.empty() ? build_info::revision : revision},
          {"compiler", std::string(build_info::compiler)},
          {"deal.II", std::string(build_info::deal_ii_version)},
          {"gmsh", gmsh_version()},
          {"Eigen", std::string(build_info::eigen_version)},
          {"HDF5", std::string(build_info::hdf5_version)},
          {"BLAS", blas_name()},
          {"cpu", processor_name()},
          {"instructions", instructions()},
          {"cores", number(std::thread::hardware_concurrency())},
          {"threads",
           number(global_control::active_value(global_control::max_allowed_parallelism))},
          {"date", utc_now()}};
}

}  // namespace springcheck
