#pragma once

// Which tests, methods and solvers read a setting: for setting_table.cpp alone.

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
  return !in_tests<Test::bending, Test::traction, Test::affine>(test);
}

template <mss::Method... springs>
bool of_springs(const CaseSettings& c) {
  const auto* model = std::get_if<mss::Method>(&c.method.model);
  return model != nullptr && ((*model == springs) || ...);
}

inline bool by_elements(const CaseSettings& c) {
  return is_finite_element(c.method);
}

inline bool of_tissue(const CaseSettings& c) {
  return is_tissue(c.method);
}

inline bool remembers(const CaseSettings& c) {
  return is_tissue(c.method) && !is_thesis_tissue(c.method);
}

inline bool through_time(const CaseSettings& c) {
  return !is_measured(c.method) && goes_through_time(c);
}

inline bool along_time(const CaseSettings& c) {
  return !is_measured(c.method) && has_history(c);
}

inline bool with_dashpots(const CaseSettings& c) {
  return through_time(c) && !is_tissue(c.method);
}

inline bool at_rest(const CaseSettings& c) {
  return is_springs(c.method) && solver_of(c) == Solver::static_equilibrium;
}

inline bool reads_lattice(const CaseSettings& c) {
  const auto* law = std::get_if<fem_reference::Law>(&c.method.model);
  return law != nullptr && *law == fem_reference::Law::cauchy_born;
}

inline bool reads_diagonal_ratio(const CaseSettings& c) {
  using enum fem_reference::Springs;
  const auto lattice = c.elements.lattice.springs;
  return of_springs<mss::Method::fd, mss::Method::cf>(c) ||
         (reads_lattice(c) && (lattice == fd || lattice == cf));
}

inline bool reads_stiffness_form(const CaseSettings& c) {
  return of_springs<mss::Method::fd, mss::Method::cf, mss::Method::nfd>(c) ||
         (reads_lattice(c) &&
          c.elements.lattice.springs != fem_reference::Springs::baudet);
}

inline bool swings(const CaseSettings& c) {
  return along_time(c) && c.dynamics.oscillation.has_value();
}

inline bool has_load_points(const CaseSettings& c) {
  return along_time(c) && !c.dynamics.load.empty() && !c.dynamics.oscillation;
}

inline bool has_step_ratio(const CaseSettings& c) {
  return through_time(c) && !c.dynamics.time_step;
}

inline bool is_random(const CaseSettings& c) {
  return at_rest(c) || (has_cells(c) && reads_seed(c.body.block));
}

inline bool of_all_but_measured(const CaseSettings& c) {
  return !is_measured(c.method);
}

inline bool elastic(const CaseSettings& c) {
  return !is_tissue(c.method);
}

inline bool of_tissue_without_inertia(const CaseSettings& c) {
  return is_tissue(c.method) && !goes_through_time(c);
}

template <bool (*has_plate)(Test)>
bool of_users_plate(const CaseSettings& c) {
  return !has_cells(c) && has_plate(c.test);
}

// With what becomes of the setting where nothing of the run reads it:

constexpr std::string_view without_time = "without a solver that goes through time",
                           without_tissue =
                               "without mss-tissue or fem-tissue or mss-thesis-tissue or "
                               "mss-thesis-tissue-relative as method or reference";

constexpr Readers all{}, of_cells{has_cells}, of_blocks{body_is<BodyShape::block>},
    of_lower_plates{of_users_plate<has_lower_plate>},
    of_upper_plates{of_users_plate<has_upper_plate>}, of_chance{is_random},
    of_elastic{elastic}, of_diagonals{reads_diagonal_ratio},
    of_moduli{reads_stiffness_form}, of_fem{by_elements}, of_solvers{of_all_but_measured},
    of_rest{at_rest};
constexpr Readers of_custom{of_springs<mss::Method::custom>, Unread::refused,
                            "without mss-custom as method or reference"};
constexpr Readers of_tetrahedra{of_springs<mss::Method::vangelder, mss::Method::lloyd>,
                                Unread::refused,
                                "without mss-vangelder or mss-lloyd as method or "
                                "reference"};
constexpr Readers of_continua{reads_lattice, Unread::refused,
                              "without fem-cauchy-born as method or reference"};
constexpr Readers of_steps{through_time, Unread::refused_as_option, without_time},
    of_usual_steps{has_step_ratio, Unread::refused_as_option, without_time},
    of_time{along_time, Unread::refused_as_option, without_time},
    of_points{has_load_points, Unread::refused_as_option, without_time},
    of_swings{swings, Unread::refused_as_option, without_time},
    of_dashpots{with_dashpots, Unread::refused_as_option,
                "without a solver that goes through time, of springs or fem-explicit "
                "methods"},
    of_histories{along_time, Unread::refused, without_time};
constexpr Readers of_living{of_tissue, Unread::refused, without_tissue},
    of_tissue_at_rest{of_tissue_without_inertia, Unread::refused_as_option,
                      "without a method of tissue whose solver is static"},
    of_memory{remembers, Unread::refused,
              "without mss-tissue or fem-tissue as method or reference"};

// Which runs need a setting:

inline bool has_body_cells(const RunSettings& run) {
  return has_cells(run.common);
}

inline bool is_elastic(const RunSettings& run) {
  return runs(run, elastic);
}

inline bool runs_custom(const RunSettings& run) {
  return runs(run, of_springs<mss::Method::custom>);
}

inline bool runs_tissue(const RunSettings& run) {
  return runs(run, of_tissue);
}

}  // namespace springcheck::setting_table
