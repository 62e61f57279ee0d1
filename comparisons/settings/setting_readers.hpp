#pragma once

// Which tests, methods and solvers read a setting. This is for setting_table.cpp alone.

#include "comparisons/settings/setting.hpp"

namespace springcheck::setting_table {

template <BodyShape... shapes>
bool body_is(const CaseSettings& c) {
  return ((c.body.shape == shapes) || ...);
}

template <Test... tests>
bool in_tests(Test test) {
  return ((test == tests) || ...);
}

inline bool has_cells(const CaseSettings& c) {
  return !body_is<BodyShape::file>(c);
}

inline bool deforms(Test test) {
  return entry_of(test).deforms;
}

inline bool leaves_surfaces_free(Test test) {
  return test != Test::affine;
}

inline bool at_rest(const CaseSettings& c) {
  return solver_of(c) == Solver::static_equilibrium;
}

inline bool swings(const CaseSettings& c) {
  return has_history(c) && c.dynamics.oscillation.has_value();
}

inline bool has_load_points(const CaseSettings& c) {
  return has_history(c) && !c.dynamics.load.empty() && !c.dynamics.oscillation;
}

inline bool has_step_ratio(const CaseSettings& c) {
  return goes_through_time(c) && !c.dynamics.time_step;
}

inline bool is_random(const CaseSettings& c) {
  return (reads(c, "seed") && at_rest(c)) || (has_cells(c) && reads_seed(c.body.block));
}

inline bool is_solved(const CaseSettings& c) {
  return !c.method.solvers.empty();
}

inline bool is_elastic(const CaseSettings& c) {
  return c.method.is_elastic;
}

inline bool has_no_inertia(const CaseSettings& c) {
  return !goes_through_time(c);
}

template <bool TestName::*has_plate>
bool of_users_plate(const CaseSettings& c) {
  return !has_cells(c) && entry_of(c.test).*has_plate;
}

// The readers of settings, with what becomes of a setting where nothing of the run reads
// it:

constexpr std::string_view without_time = "without a solver that goes through time";

constexpr Readers all{}, of_cells{has_cells}, of_blocks{body_is<BodyShape::block>},
    of_lower_plates{of_users_plate<&TestName::lower_plate>},
    of_upper_plates{of_users_plate<&TestName::upper_plate>}, of_chance{is_random},
    of_elastic{is_elastic}, of_solvers{is_solved};
constexpr Readers of_steps{goes_through_time, Unread::refused_as_option, without_time},
    of_usual_steps{has_step_ratio, Unread::refused_as_option, without_time},
    of_time{has_history, Unread::refused_as_option, without_time},
    of_points{has_load_points, Unread::refused_as_option, without_time},
    of_swings{swings, Unread::refused_as_option, without_time},
    of_histories{has_history, Unread::refused, without_time};

/// The readers that are the methods whose entry lists the setting.
constexpr Readers of_methods{.of_methods = true},
    of_methods_as_option{.unread = Unread::refused_as_option, .of_methods = true},
    of_methods_alone{.unread = Unread::refused, .of_methods = true},
    of_methods_at_rest{.is_one = at_rest, .of_methods = true},
    of_methods_without_inertia{.is_one = has_no_inertia, .of_methods = true},
    of_dashpots{goes_through_time, Unread::refused_as_option,
                "without a solver that goes through time, of springs or fem-explicit "
                "methods",
                true},
    of_tissue_at_rest{has_no_inertia, Unread::refused_as_option,
                      "without a method of tissue whose solver is static", true};

// Whether a run needs a setting:

inline bool has_body_cells(const RunSettings& run) {
  return has_cells(run.common);
}

inline bool has_elastic_methods(const RunSettings& run) {
  return runs(run, is_elastic);
}

}  // namespace springcheck::setting_table
