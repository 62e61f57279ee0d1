#include "comparisons/system/processor.hpp"

#include <fstream>

#include "dynamics/blocks/instruction_set.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

std::string processor_info(const char* name) {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with(name)) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::string processor_name() {
  return processor_info("model name");
}

std::string instructions() {
  return std::string(name_of(dynamics::best_instruction_set())) + " " +
         processor_info("vendor_id");
}

std::string machine_digits() {
  std::string id;
  return std::ifstream("/etc/machine-id") >> id ? sha256("springcheck " + id).substr(0, 8)
                                                : "";
}

}  // namespace springcheck
