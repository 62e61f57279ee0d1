#include "comparisons/run_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include "comparisons/grids.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

using Settings = std::map<std::string, Given, std::less<>>;

const Given& required(const Settings& settings, const std::string& key,
                      const std::string& file, const std::string& expected) {
  const auto found = settings.find(key);
  if (found == settings.end())
    throw InputError(file + ":1:1", "key '" + key + "'", expected, "none");
  return found->second;
}

template <class Value, class Read>
Value value_or(const Settings& settings, std::string_view key, Value otherwise,
               Read&& read) {
  const auto found = settings.find(key);
  return found == settings.end() ? otherwise : Value(std::invoke(read, found->second));
}

Test test_of(const Given& given) {
  const std::string name = given.text();
  std::string names;
  for (const Test test :
       {Test::compression, Test::tension, Test::shearing, Test::torsion, Test::bending}) {
    if (name_of(test) == name) return test;
    names += (names.empty() ? "" : ", ") + std::string(name_of(test));
  }
  given.refuse("one of " + names);
}

Method method_of(const Given& given, const std::string& name) {
  const Method* method = find_method(name);
  if (method == nullptr)
    throw InputError(given.place(), "", "one of " + names_of(methods()),
                     "'" + name + "'");
  return *method;
}

ElementName element_of(const Given& given, const std::string& name) {
  const ElementName* element = find_element(name);
  if (element == nullptr)
    throw InputError(given.place(), "", "one of " + names_of(elements()),
                     "'" + name + "'");
  return *element;
}

std::vector<Method> methods_of(const Given& given) {
  std::vector<Method> all;
  for (const std::string& name : given.texts()) {
    all.push_back(method_of(given, name));
    if (std::ranges::count(all, name, &Method::name) > 1)
      throw InputError(given.place(), "", "each name once", "'" + name + "' twice");
  }
  return all;
}

std::array<double, 3> size_of(const Given& given) {
  // Far beyond any body, and their cubes stay far from overflow.
  constexpr double shortest = 1e-9, longest = 1e9;
  const auto size = given.three_numbers();
  if (std::ranges::any_of(
          size, [](double length) { return !(length >= shortest && length <= longest); }))
    given.refuse("three lengths between 1e-9 and 1e9 m");
  return size;
}

std::array<int, 3> cells_of(const Given& given) {
  std::array<int, 3> cells{};
  const auto counts = given.three_integers();
  for (std::size_t i = 0; i < 3; ++i) {
    if (counts[i] < 1 || counts[i] > std::numeric_limits<int>::max())
      given.refuse("three counts of at least 1");
    cells[i] = static_cast<int>(counts[i]);
  }
  return cells;
}

double poisson_ratio_of(const Given& given) {
  const double nu = given.finite_number();
  if (!(nu > -1 && nu < 0.5)) given.refuse("a number in (-1, 0.5)");
  return nu;
}

double deformation_of(const Given& given, Test test) {
  constexpr double largest = 100;  // keeps squares of strains far from overflow
  const double deformation = test == Test::torsion ? given.angle() : given.strain();
  if (!(deformation > 0)) given.refuse("a positive number: the test gives its direction");
  if (deformation > largest) given.refuse("a deformation of at most 100");
  if (test == Test::compression && deformation >= 1)
    given.refuse("a strain below 1: the plates would meet");
  return deformation;
}

double not_negative(const Given& given) {
  const double value = given.finite_number();
  if (value < 0) given.refuse("a number of at least 0");
  return value;
}

std::optional<double> time_step_of(const Given& given) {
  if (!given.is_text()) return given.positive_number();
  if (given.text() != "auto") given.refuse("a positive time [s] or 'auto'");
  return std::nullopt;
}

unsigned seed_of(const Given& given) {
  const std::int64_t seed = given.integer();
  if (seed < 0 || seed > std::numeric_limits<unsigned>::max())
    given.refuse("an integer in [0, 4294967295]");
  return static_cast<unsigned>(seed);
}

mss::StiffnessForm stiffness_form_of(const Given& given) {
  const std::string form = given.text();
  if (form == "mu") return mss::StiffnessForm::shear_modulus;
  if (form == "E") return mss::StiffnessForm::young_modulus;
  given.refuse("'mu' or 'E'");
}

mss::Solver solver_of(const Given& given) {
  const std::string solver = given.text();
  for (const auto known :
       {mss::Solver::static_equilibrium, mss::Solver::semi_implicit_euler})
    if (solver == name_of(known)) return known;
  given.refuse("one of static, semi-implicit");
}

std::vector<Status> expect_of(const Given& given) {
  std::vector<Status> expected;
  for (const std::string& name : given.texts()) {
    const auto found =
        std::ranges::find(all_statuses(), name, [](Status s) { return name_of(s); });
    if (found == all_statuses().end()) {
      std::string names;
      for (const Status status : all_statuses())
        names += (names.empty() ? "" : ", ") + std::string(name_of(status));
      given.refuse("statuses among " + names);
    }
    expected.push_back(*found);
  }
  return expected;
}

Vector3 gravity_of(const Given& given) {
  const auto gravity = given.three_numbers();
  const Vector3 vector(gravity[0], gravity[1], gravity[2]);
  if (vector.isZero(0)) given.refuse("a vector other than zero [m/s^2]");
  return vector;
}

/// Settings that belong to some tests only.
void check_applicable(const Settings& settings, Test test) {
  const auto refuse = [&](const char* key, const char* why) {
    if (const auto found = settings.find(std::string_view(key)); found != settings.end())
      throw InputError(found->second.place(), "", why, "a value");
  };
  if (test == Test::bending)
    refuse("deformation", "no deformation in bending, where gravity acts");
  else
    refuse("gravity", "no gravity but in bending");
}

/// "N" or "NX,NY,NZ" behind a reference's '@'.
std::vector<int> reference_cells_of(const Given& given, const std::string& text) {
  const std::string expected =
      "METHOD[:ELEMENT], @NX,NY,NZ, @N or @converged behind it, counts of at least 1";
  std::vector<int> cells;
  std::istringstream counts(text);
  for (std::string count; std::getline(counts, count, ',');) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc{} || end != count.data() + count.size() || value < 1)
      given.refuse(expected);
    cells.push_back(value);
  }
  if ((cells.size() != 1 && cells.size() != 3) || text.back() == ',')
    given.refuse(expected);
  return cells;
}

/// The cells a reference runs on beside a case.
Cells cells_beside(const ReferenceMethod& reference, const Cells& cells) {
  if (reference.cells.empty()) return cells;
  const auto refuse = [&](const std::string& expected) {
    throw InputError(reference.place, "cells of the reference",
                     fmt::format("{} the case's {}", expected, fmt::join(cells, ",")),
                     fmt::format("{}", fmt::join(reference.cells, ",")));
  };
  if (reference.cells.size() == 1) {
    const int along_x = reference.cells.front();
    if (along_x % cells[0] != 0) refuse("a whole multiple of the first of");
    return refined(cells, along_x / cells[0]);
  }
  const Cells finer{reference.cells[0], reference.cells[1], reference.cells[2]};
  if (!is_refinement(finer, cells)) refuse("whole multiples of");
  return finer;
}

}  // namespace

ReferenceMethod reference_named(const Given& given) {
  const std::string text = given.joined();
  const std::size_t at = text.find('@');
  const std::string what = text.substr(0, at);
  const std::size_t colon = what.find(':');
  ReferenceMethod reference{.method = method_of(given, what.substr(0, colon)),
                            .element = *find_element("q1-sri"),
                            .place = given.place()};
  if (colon != std::string::npos) {
    if (!is_finite_element(reference.method))
      given.refuse("an element for fem- methods only");
    reference.element = element_of(given, what.substr(colon + 1));
  }
  if (at == std::string::npos) return reference;
  const std::string grid = text.substr(at + 1);
  if (grid == "converged")
    reference.grid = ReferenceGrid::converged;
  else
    reference.cells = reference_cells_of(given, grid);
  return reference;
}

const std::vector<SettingKey>& option_keys() {
  static const std::vector<SettingKey> keys{
      {"method", "comma-separated list of methods, see 'springcheck list methods'"},
      {"element", "finite element on hexahedra: q1, q1-sri (default)"},
      {"nu", "Poisson ratio, in (-1, 0.5)"},
      {"young", "Young's modulus [Pa]"},
      {"density", "mass density [kg/m^3]"},
      {"deformation",
       "strain, or angle of torsion [rad]; '5%' and '45deg' are understood"},
      {"diagonal-ratio", "A = k_f/k_c of mss-fd and mss-cf (default 1)"},
      {"stiffness-form", "spring constants from mu (default) or, as Eq. 5.12 prints, E"},
      {"cells", "number of cells along x,y,z"},
      {"size", "size of the block along x,y,z [m]"},
      {"solver",
       "of spring methods: static (default) or semi-implicit (dynamics); finite elements "
       "are always static"},
      {"dt", "time step [s], or auto (default): 0.9 of the stability limit"},
      {"force-dt", "run even with a time step above the stability limit"},
      {"duration", "time over which the load grows in dynamics [s] (default 10)"},
      {"damping", "dashpots in dynamics, fraction of critical (default 0.05)"},
      {"seed", "decides between equal directions out of an unstable state (default 1)"},
      {"reference",
       "METHOD[:ELEMENT][@CELLS|@converged] that deviations are measured against "
       "(default on the same mesh: fem-hooke:q1-sri up to a deformation of .02, "
       "fem-stvk:q1-sri above)"}};
  return keys;
}

const std::vector<SettingKey>& scene_only_keys() {
  static const std::vector<SettingKey> keys{
      {"test", "compression, tension, shearing, torsion or bending"},
      {"gravity", "acceleration in bending [m/s^2]"},
      {"expect", "statuses that end a run of one method with exit status 0"}};
  return keys;
}

RunSettings make_run_settings(const std::string& name, const std::string& file,
                              const std::vector<GivenSetting>& given) {
  Settings settings;
  for (const auto& [key, value] : given) settings.insert_or_assign(key, value);
  const auto need = [&](const char* key, const char* expected) -> const Given& {
    return required(settings, key, file, expected);
  };
  const Test test = test_of(need("test", "the name of a test"));
  check_applicable(settings, test);

  CaseSettings common{
      .scene = name,
      .test = test,
      .block = {.size = size_of(need("size", "three lengths [m]")),
                .cells = cells_of(need("cells", "three counts"))},
      .material = {.young_modulus =
                       need("young", "Young's modulus [Pa]").positive_number(),
                   .poisson_ratio = poisson_ratio_of(need("nu", "a number in (-1, 0.5)")),
                   .density = need("density", "a density [kg/m^3]").positive_number()},
      .gravity = Vector3::Zero(),
      .deformation = std::nullopt,
      .method = {},
      .element = value_or(settings, "element", *find_element("q1-sri"),
                          [](const Given& g) { return element_of(g, g.text()); }),
      .stiffness_form = value_or(settings, "stiffness-form",
                                 mss::StiffnessForm::shear_modulus, stiffness_form_of),
      .diagonal_ratio = value_or(settings, "diagonal-ratio", 1., not_negative),
      .solver = value_or(settings, "solver", mss::Solver::static_equilibrium, solver_of),
      .dynamics =
          {.duration = value_or(settings, "duration", 10., &Given::positive_number),
           .time_step = value_or(settings, "dt", std::optional<double>{}, time_step_of),
           .force_time_step = value_or(settings, "force-dt", false, &Given::truth),
           .damping_ratio = value_or(settings, "damping", 0.05, not_negative)},
      .seed = value_or(settings, "seed", 1U, seed_of)};
  if (test == Test::bending)
    common.gravity = gravity_of(need("gravity", "an acceleration [m/s^2]"));
  else
    common.deformation = deformation_of(need("deformation", "a strain or angle"), test);

  RunSettings run{
      .common = common,
      .cells_place = need("cells", "three counts").place(),
      .methods = methods_of(need("method", "a list of methods")),
      .reference = std::nullopt,
      .expect = value_or(settings, "expect", std::vector{Status::ok}, expect_of)};
  if (const auto reference = settings.find(std::string_view("reference"));
      reference != settings.end())
    run.reference = reference_named(reference->second);
  return run;
}

std::vector<Request> requests(const RunSettings& run) {
  constexpr double small_deformation = 0.02;
  const bool is_small = run.common.deformation.value_or(1) <= small_deformation;
  const ReferenceMethod reference = run.reference.value_or(ReferenceMethod{
      *find_method(is_small ? "fem-hooke" : "fem-stvk"), *find_element("q1-sri")});
  std::vector<Request> all;
  for (const Method& method : run.methods) {
    Request request{.settings = run.common, .reference = run.common};
    request.settings.method = method;
    request.reference->method = reference.method;
    request.reference->element = reference.element;
    request.reference->block.cells = cells_beside(reference, run.common.block.cells);
    request.reference_grid = reference.grid;
    if (reference.grid == ReferenceGrid::one &&
        settings_json(request.settings) == settings_json(*request.reference))
      request.reference.reset();
    all.push_back(request);
  }
  return all;
}

}  // namespace springcheck
