#include "comparisons/cases/status.hpp"

namespace springcheck {

const std::vector<Status>& all_statuses() {
  static const std::vector<Status> all{Status::ok,
                                       Status::wrinkled,
                                       Status::inverted,
                                       Status::indefinite,
                                       Status::no_equilibrium,
                                       Status::diverged,
                                       Status::not_converged,
                                       Status::refused};
  return all;
}

std::string_view name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::wrinkled:
      return "wrinkled";
    case Status::inverted:
      return "inverted";
    case Status::indefinite:
      return "indefinite";
    case Status::no_equilibrium:
      return "no_equilibrium";
    case Status::diverged:
      return "diverged";
    case Status::not_converged:
      return "not_converged";
    case Status::refused:
      return "refused";
  }
  return {};
}

}  // namespace springcheck
