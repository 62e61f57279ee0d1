#pragma once

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace springcheck::fem_reference {

/// Everything that is logged while it lives, at the level of debugging.
class CapturedLog {
 public:
  CapturedLog() : before_(spdlog::default_logger()) {
    auto logger = std::make_shared<spdlog::logger>(
        "captured", std::make_shared<spdlog::sinks::ostream_sink_st>(text_));
    logger->set_pattern("%v");
    logger->set_level(spdlog::level::debug);
    spdlog::set_default_logger(std::move(logger));
  }
  ~CapturedLog() { spdlog::set_default_logger(before_); }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  /// The relative residuals of Newton's iterates, one list per search.
  [[nodiscard]] std::vector<std::vector<double>> residuals() const {
    std::vector<std::vector<double>> calls;
    std::istringstream lines(text_.str());
    const std::string label = "residual ";
    for (std::string line; std::getline(lines, line);) {
      if (line.find("newton ") == std::string::npos) continue;
      if (line.find("newton 0:") != std::string::npos) calls.emplace_back();
      calls.back().push_back(std::stod(line.substr(line.find(label) + label.size())));
    }
    return calls;
  }

  struct Attempt {
    double to;  // load fraction
    bool found;
  };
  /// The load steps of find_equilibrium(), failed ones too.
  [[nodiscard]] std::vector<Attempt> attempts() const {
    std::vector<Attempt> all;
    std::istringstream lines(text_.str());
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("load ") && line.find("residual") != std::string::npos)
        all.push_back({.to = std::stod(line.substr(5)),
                       .found = line.find(": minimum") != std::string::npos});
    return all;
  }

 private:
  std::shared_ptr<spdlog::logger> before_;
  std::ostringstream text_;
};

}  // namespace springcheck::fem_reference
