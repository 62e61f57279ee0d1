#pragma once

#include <string_view>
#include <vector>

namespace springcheck {

/// How a case ended. The words are those of the command-line interface.
enum class Status {
  ok,
  wrinkled,
  inverted,
  indefinite,
  no_equilibrium,
  diverged,
  not_converged,
  refused
};

std::string_view name_of(Status status);
std::string_view description_of(Status status);
const std::vector<Status>& all_statuses();

}  // namespace springcheck
