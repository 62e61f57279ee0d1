// What every entry of a method must be, and whether it does what it says.

#include "comparisons/methods/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/methods/families.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/setting.hpp"
#include "fem_reference/laws/materials.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(methods_test)

namespace {

/// A small body of such cells that is hardly compressed, in a short time where it moves.
CaseSettings small_case(const Method& method, CellType cells, Solver solver) {
  std::vector<std::string> changes{"method=" + method.name, "cells=2,2,2",
                                   "deformation=1%",
                                   "cell-type=" + std::string(name_of(cells)),
                                   "solver=" + std::string(name_of(solver))};
  if (reads(method, "stiffness")) changes.emplace_back("stiffness=400,100,150");
  if (reads(method, "organ")) changes.emplace_back("organ=liver");
  CaseSettings settings = case_of("compression", changes);
  settings.dynamics.duration = 0.01;
  if (solver == Solver::implicit_euler) settings.dynamics.time_step = 1e-3;  // no limit
  return settings;
}

Solution solution_of(const CaseSettings& settings) {
  const Mesh mesh = build_mesh(settings.body);
  return settings.method.solve(settings, mesh, mechanical_scene(settings, mesh), 1, {});
}

bool is_refused(const CaseSettings& settings) {
  return solution_of(settings).status == SolveStatus::refused;
}

template <class Values, class Value>
bool has(const Values& values, const Value& value) {
  return std::ranges::find(values, value) != values.end();
}

template <class Entries>
void expect_names_once(const Entries& entries) {
  std::set<std::string_view> names;
  for (const auto& entry : entries)
    BOOST_TEST(names.insert(entry.name).second, entry.name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_and_looks_belong_to_one_entry_each) {
  expect_names_once(methods());
  expect_names_once(elements());
  expect_names_once(lattices());
  std::set<std::string_view> colours;
  std::map<std::string_view, const Method*> charted_marks;
  for (const Method& method : methods()) {
    BOOST_TEST(colours.insert(method.look.colour).second, method.name);
    if (method.charted.empty()) continue;
    const auto [of_mark, is_first] = charted_marks.emplace(method.look.mark, &method);
    const auto& [mark, other] = *of_mark;
    BOOST_TEST((is_first || other->name == method.at_rest ||
                (method.lattice && other->lattice &&
                 method.lattice->springs == other->lattice->springs)),
               method.name);
    // Charts tell variants by how a mark is filled: of matplotlib's these can be.
    BOOST_TEST(std::string_view("ov^<>8sp*hHDdPX").find(method.look.mark) !=
                   std::string_view::npos,
               method.name);
  }
}

BOOST_AUTO_TEST_CASE(entries_are_complete) {
  for (const Method& method : methods()) BOOST_TEST_CONTEXT(method.name) {
      BOOST_TEST(!method.description.empty());
      BOOST_TEST(!method.source.empty());
      BOOST_TEST(!method.covers.empty());
      if (!method.at_rest.empty()) {
        const std::size_t colon = method.at_rest.find(':');
        BOOST_TEST((find_method(method.at_rest.substr(0, colon)) != nullptr));
        BOOST_TEST(((colon == std::string::npos && reads(method, "element")) ||
                    find_element(method.at_rest.substr(colon + 1)) != nullptr));
      }
      // A star is others' methods and variants.
      BOOST_TEST((method.charted.empty() || method.look.mark != "*"));
      BOOST_TEST(!method.cells.empty());
      BOOST_TEST_REQUIRE(!method.solvers.empty());
      BOOST_TEST((method.solve != nullptr));
      BOOST_TEST((method.linear_systems != nullptr));
      BOOST_TEST((!method.lattice || method.lattice->name == method.name));
      const CaseSettings own =
          small_case(method, method.cells.front(), method.solvers.front());
      BOOST_TEST((goes_through_time(own) || method.seconds.at_rest > 0));
      const bool moves = has(method.solvers, Solver::verlet);
      BOOST_TEST((method.seconds.in_motion > 0) == moves);
      BOOST_TEST((method.seconds.in_motion_off_grids > 0) == moves);
      BOOST_TEST((method.stepping != nullptr) == moves);
    }
}

// Each place once; the thesis's springs and its reference are the first.
BOOST_AUTO_TEST_CASE(the_foremost_are_in_order) {
  for (const Family family : {Family::springs, Family::finite_elements}) {
    int place = 0;
    for (const Method* method : foremost(family)) BOOST_TEST(method->foremost == ++place);
  }
  BOOST_TEST(foremost(Family::springs).front()->name == "mss-cf");
  BOOST_TEST(thesis_law().name == "fem-hencky");
  BOOST_TEST(names_of(laws()) == "fem-hooke, fem-stvk, fem-hencky, fem-cauchy-born");
}

// In double precision every law has elements on tetrahedra; in single precision only the
// kernels step, which are for hexahedra.
BOOST_AUTO_TEST_CASE(elements_that_charts_move_are_those_of_the_cells) {
  using enum dynamics::Precision;
  const auto names = [](CellType cells, dynamics::Precision precision) {
    std::string all;
    for (const Model& model : moving_elements(cells, precision))
      all += name_of(model) + "; ";
    return all;
  };
  BOOST_TEST(names(CellType::hexahedron, single_precision) ==
             "fem-explicit-8p, float; fem-explicit-1p, float; ");
  BOOST_TEST(names(CellType::hexahedron, double_precision) ==
             "fem-explicit-8p, double; fem-explicit-1p, double; "
             "fem-explicit-hencky:q1-sri, double; ");
  BOOST_TEST(names(CellType::tetrahedron, double_precision) ==
             "fem-explicit-hooke:q1-nodal on tetrahedra, double; "
             "fem-explicit-stvk:q1-nodal on tetrahedra, double; "
             "fem-explicit-hencky:q1-nodal on tetrahedra, double; ");
  BOOST_TEST(names(CellType::tetrahedron, single_precision) == "");
}

BOOST_AUTO_TEST_CASE(a_law_is_at_rest_what_it_is_in_motion) {
  for (const Method& method : methods()) {
    const Method& rest = at_rest(method);
    BOOST_TEST(rest.at_rest.empty(), method.name);
    if (!reads(method, "element")) continue;
    BOOST_TEST(is_law(rest.name), method.name);
    BOOST_TEST(is_law(method.name) == method.at_rest.empty(), method.name);
    BOOST_TEST(method.volume_lost_near_half == rest.volume_lost_near_half, method.name);
  }
  BOOST_TEST(at_rest(*find_method("fem-explicit-8p")).name == "fem-stvk");
  BOOST_TEST(at_rest(*find_method("fem-explicit-hencky")).name == "fem-hencky");
  BOOST_TEST(at_rest(*find_method("mss-cf")).name == "mss-cf");
}

// Springs follow laws that finite elements are known by.
BOOST_AUTO_TEST_CASE(a_law_that_springs_follow_is_one_of_finite_elements) {
  for (const Method& method : methods()) {
    const Method& law = followed_law(method, thesis_law());
    BOOST_TEST(std::ranges::count(laws(), &law) == 1, method.name);
    BOOST_TEST((method.law.empty() || method.same_law_as.empty()), method.name);
  }
  BOOST_TEST(followed_law(*find_method("mss-stvk"), thesis_law()).name == "fem-stvk");
  BOOST_TEST(followed_law(*find_method("mss-cf"), thesis_law()).name == "fem-hencky");
}

// The correction is not always there where a user may turn it off.
BOOST_AUTO_TEST_CASE(a_volume_correction_is_in_the_network) {
  for (const Method& method : methods()) {
    if (!method.network) continue;
    CaseSettings settings =
        small_case(method, method.cells.front(), method.solvers.front());
    settings.material.poisson_ratio = 0.3;
    settings.springs.volume_correction = mss::VolumeCorrection::off;
    const auto network = method.network(settings, build_mesh(settings.body));
    BOOST_TEST_REQUIRE(network.has_value(), method.name);
    BOOST_TEST((network->volume_moduli.kappa != 0) == method.corrects_volume,
               method.name);
  }
}

BOOST_AUTO_TEST_CASE(own_settings_are_settings_that_some_case_reads) {
  std::set<std::string_view> listed;
  for (const Method& method : methods())
    for (const std::string_view key : method.reads) {
      listed.insert(key);
      const Setting* setting = find_setting(key);
      BOOST_TEST_REQUIRE((setting != nullptr), method.name << ": " << key);
      const bool is_read = std::ranges::any_of(method.solvers, [&](Solver solver) {
        return reads(small_case(method, method.cells.front(), solver), *setting);
      });
      BOOST_TEST(is_read, method.name << ": " << key);
    }
  for (const Setting& setting : all_settings())
    BOOST_TEST((!setting.readers.of_methods || listed.contains(setting.key)),
               setting.key);
}

// A setting that a lattice does not list changes nothing of its continuum, one that it
// lists does: strain energy where nu is not 1/4 and shear and stretch act together.
BOOST_AUTO_TEST_CASE(a_lattice_brings_its_settings_to_finite_elements) {
  for (const LatticeName& lattice : lattices())
    for (const auto& [key, change] :
         {std::pair<const char*, void (*)(CaseSettings&)>{
              "diagonal-ratio", [](CaseSettings& c) { c.springs.diagonal_ratio = 3; }},
          {"stiffness-form", [](CaseSettings& c) {
             c.springs.stiffness_form = mss::StiffnessForm::young_modulus;
           }}}) {
      const std::string own = "lattice=" + std::string(lattice.name);
      const auto energy = [&](bool is_changed) {
        CaseSettings c =
            case_of("compression", {"method=fem-cauchy-born", "nu=0.3", own});
        if (is_changed) change(c);
        const Eigen::Matrix3d H =
            (Eigen::Matrix3d() << 0.2, 0.1, 0, 0, -0.1, 0, 0, 0, 0).finished();
        return fem_reference::energy(
            fem_reference::cauchy_born(c.material, lattice_of(c)), H);
      };
      const auto continuum = case_of("compression", {"method=fem-cauchy-born", own});
      BOOST_TEST((energy(true) != energy(false)) == has(lattice.reads, key),
                 lattice.name << ": " << key);
      BOOST_TEST(reads(continuum, *find_setting(key)) == has(lattice.reads, key),
                 lattice.name << ": " << key);
    }
}

BOOST_AUTO_TEST_CASE(cells_are_refused_that_an_entry_does_not_list) {
  for (const Method& method : methods())
    for (const CellType cells : all_cell_types)
      BOOST_TEST(is_refused(small_case(method, cells, method.solvers.front())) !=
                     has(method.cells, cells),
                 method.name << " on " << name_of(cells));
}

BOOST_AUTO_TEST_CASE(solvers_are_refused_that_an_entry_does_not_list) {
  for (const Method& method : methods())
    for (const Solver solver : all_values<Solver>()) {
      const CaseSettings settings = small_case(method, method.cells.front(), solver);
      BOOST_TEST(is_refused(settings) != has(method.solvers, solver_of(settings)),
                 method.name << " by " << name_of(solver));
    }
}

// The refusal has words, not a status alone.
BOOST_AUTO_TEST_CASE(a_refusal_says_why) {
  for (const Method& method : methods())
    for (const CellType cells : all_cell_types)
      if (!has(method.cells, cells)) {
        const Solution refused =
            solution_of(small_case(method, cells, method.solvers.front()));
        BOOST_TEST(!refused.reason.empty(), method.name << " on " << name_of(cells));
      }
}

BOOST_AUTO_TEST_CASE(a_network_is_there_where_a_case_is_not_refused) {
  for (const Method& method : methods()) {
    if (!method.network) continue;
    for (const CellType cells : all_cell_types) {
      const CaseSettings settings = small_case(method, cells, method.solvers.front());
      BOOST_TEST(method.network(settings, build_mesh(settings.body)).has_value() ==
                     has(method.cells, cells),
                 method.name << " on " << name_of(cells));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
