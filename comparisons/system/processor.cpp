#include "comparisons/system/processor.hpp"

#include <fstream>

#include "dynamics/blocks/instruction_set.hpp"
#include "meshing/basics/sha256.hpp"

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

std::string clock_policy(const std::filesystem::path& root) {
  const std::filesystem::path cpu = root / "sys/devices/system/cpu";
  const auto word_of = [&](const char* file) {
    std::string word;
    std::ifstream(cpu / file) >> word;
    return word;
  };
  const std::string governor = word_of("cpu0/cpufreq/scaling_governor"),
                    boost = word_of("cpufreq/boost"),
                    no_turbo = word_of("intel_pstate/no_turbo");
  if (governor.empty()) return "unknown";
  const bool is_told = !boost.empty() || !no_turbo.empty();
  return "governor " + governor +
         (!is_told                          ? ""
          : boost == "1" || no_turbo == "0" ? ", boost on"
                                            : ", boost off");
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
