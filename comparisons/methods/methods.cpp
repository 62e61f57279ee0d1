#include "comparisons/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/families.hpp"

namespace springcheck {
namespace {

template <class Entries>
auto find(const Entries& entries, std::string_view name) {
  const auto found = std::ranges::find_if(
      entries, [&](const auto& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> each;
    for (auto family : {spring_methods(), tissue_methods(), finite_element_methods(),
                        explicit_element_methods()})
      std::ranges::move(family, std::back_inserter(each));
    return each;
  }();
  return all;
}

const std::vector<ElementName>& elements() {
  static const std::vector<ElementName> all = finite_elements();
  return all;
}

const std::vector<LatticeName>& lattices() {
  static const std::vector<LatticeName> all = [] {
    std::vector<LatticeName> each;
    for (const Method& method : methods())
      if (method.lattice) each.push_back(*method.lattice);
    return each;
  }();
  return all;
}

const Method* find_method(std::string_view name) {
  return find(methods(), name);
}
const ElementName* find_element(std::string_view name) {
  return find(elements(), name);
}

std::vector<const Method*> foremost(Family family) {
  std::vector<const Method*> all;
  for (const Method& method : methods())
    if (method.family == family && method.foremost > 0) all.push_back(&method);
  std::ranges::sort(all, {}, &Method::foremost);
  return all;
}

const Method& at_rest(const Method& method) {
  if (method.at_rest.empty()) return method;
  return *find_method(method.at_rest.substr(0, method.at_rest.find(':')));
}

std::vector<Model> moving_elements(CellType cells, dynamics::Precision precision) {
  std::vector<const Method*> all;
  for (const Method& method : methods())
    if (method.family == Family::finite_elements) all.push_back(&method);
  std::ranges::stable_sort(all, {}, [](const Method* method) {
    return std::pair(method->foremost == 0, method->foremost);
  });
  std::vector<Model> models;
  for (const Method* method : all)
    for (Model model : method->charted) {
      model.method = method->name;
      if (model.cells == cells && model.precision == precision) models.push_back(model);
    }
  return models;
}

std::vector<const Method*> laws() {
  std::vector<const Method*> all;
  for (const Method& method : methods())
    if (reads(method, "element") && !method.follows_solver) all.push_back(&method);
  return all;
}

bool is_law(std::string_view name) {
  const auto all = laws();
  return std::ranges::find(all, name, &Method::name) != all.end();
}

const Method& usual_law(bool is_small) {
  return *find_method(is_small ? "fem-hooke" : "fem-stvk");
}

std::string caution_near_half(const Method& law, const CaseSettings& settings) {
  constexpr double near_half = 0.45;
  const bool is_small = settings.deformation.value_or(1) <= small_deformation &&
                        settings.deformation.value_or(1) >= -small_deformation;
  if (settings.material.poisson_ratio < near_half || is_small) return {};
  const Method* best = &law;
  for (const Method* other : laws())
    if (other->volume_lost_near_half > 0 &&
        other->volume_lost_near_half < best->volume_lost_near_half)
      best = other;
  if (best == &law) return {};
  const auto percent = [](const Method& of) {
    return fmt::format("{:.2g} %", 100 * of.volume_lost_near_half);
  };
  return fmt::format(
      "{} lets volume change near nu = 1/2, where the material hardly does: at nu = "
      "0.499 and compressed by 20 % a cube loses {} of it, by {} {}.",
      law.name, percent(law), best->name, percent(*best));
}

const Method& thesis_law() {
  const auto all = laws();
  return **std::ranges::find_if(all, &Method::of_thesis);
}

const Method& followed_law(const Method& method, const Method& otherwise) {
  return method.same_law_as.empty() ? otherwise : *find_method(method.same_law_as);
}

const Method& followed_law(const CaseSettings& settings, const Method& otherwise) {
  const Method& method = settings.method;
  if (method.same_law_as.empty() && method.corrects_volume &&
      reads(method, "spring-strain")) {
    const auto strain = springs_of(settings, method.fixed).strain_measure;
    for (const Method& other : methods())
      if (!other.same_law_as.empty() && other.fixed.strain == strain)
        return followed_law(other, otherwise);
  }
  return followed_law(method, otherwise);
}

const Method& continuum_of_lattices() {
  return *find_method("fem-cauchy-born");
}

}  // namespace springcheck
