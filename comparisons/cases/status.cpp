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

std::string_view description_of(Status status) {
  switch (status) {
    case Status::ok:
      return "equilibrium, and stable: its tangent is positive definite. In dynamics: "
             "the "
             "end was reached";
    case Status::wrinkled:
      return "equilibrium whose free faces zigzag from cell to cell";
    case Status::inverted:
      return "equilibrium with a cell turned inside out at a corner";
    case Status::indefinite:
      return "equilibrium that is not stable";
    case Status::no_equilibrium:
      return "the energy has no minimum before the full load; the fraction reached is "
             "reported";
    case Status::diverged:
      return "the dynamics blew up";
    case Status::not_converged:
      return "the solver gave up before the full load";
    case Status::refused:
      return "the method does not cover this mesh, material or time step";
  }
  return {};
}

}  // namespace springcheck
