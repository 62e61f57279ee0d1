#include "comparisons/imported/imported_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/imported/nodal_vectors.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/simulate.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/sha256.hpp"
#include "meshing/basics/text.hpp"

namespace springcheck {
namespace {

/// SHA-256 of the numbers themselves, however a file wrote them.
std::string sha256_of(const std::vector<Vector3>& vectors) {
  std::string bytes;
  for (const Vector3& v : vectors)
    for (const double component : v) {
      const double number = component + 0.;  // -0 is 0
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  return sha256(bytes);
}

void check_label(const std::string& label) {
  const auto refuse = [&](const std::string& expected) {
    throw InputError("--label", "", expected, "'" + label + "'");
  };
  if (!is_utf8(label)) throw InputError("--label", "", "a name in UTF-8", "other bytes");
  if (label.find_first_not_of(' ') == std::string::npos) refuse("a name");
  const auto is_unprintable = [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7F';
  };
  if (std::ranges::any_of(label, is_unprintable))
    throw InputError("--label", "", "printable characters", "others");
  if (label.find(',') != std::string::npos) refuse("a name without commas");
  if (find_method(label) != nullptr)
    refuse("another name than the methods' own: " + names_of(methods()));
}

/// The largest distance of a node, and which it is.
struct Farthest {
  double distance = 0;
  NodeIndex node = 0;

  void consider(double of_node, NodeIndex n) {
    if (of_node > distance) *this = {of_node, n};
  }
};

std::optional<std::string> off_supports(
    const Mesh& mesh, const Scene& scene,
    const std::vector<PrescribedComponent>& prescribed,
    const std::vector<Vector3>& displacements) {
  std::vector<Vector3> off(mesh.nodes().size(), Vector3::Zero());
  for (const PrescribedComponent& p : prescribed)
    off[p.node][p.component] =
        displacements[p.node][p.component] - prescribed_displacement(mesh, scene, p, 1);
  Farthest farthest;
  for (NodeIndex n = 0; n < off.size(); ++n) farthest.consider(off[n].norm(), n);
  if (farthest.distance <= node_tolerance(mesh)) return std::nullopt;
  return fmt::format(
      "displacements do not follow the scene's supports: node {} is {:.3g} m off, the "
      "farthest",
      farthest.node + 1, farthest.distance);
}

std::optional<std::string> forces_without_support(
    const Mesh& mesh, const std::vector<PrescribedComponent>& prescribed,
    const std::vector<Vector3>& forces) {
  constexpr double round_off = 1e-6;  // of the largest force
  const std::vector<bool> is_free = free_components(mesh, prescribed);
  Farthest largest, unsupported;
  for (NodeIndex n = 0; n < forces.size(); ++n) {
    largest.consider(forces[n].norm(), n);
    for (Eigen::Index i = 0; i < 3; ++i)
      if (is_free[3 * n + static_cast<std::size_t>(i)])
        unsupported.consider(std::abs(forces[n][i]), n);
  }
  if (unsupported.distance <= round_off * largest.distance) return std::nullopt;
  return fmt::format(
      "forces act where the scene has no support: {:.3g} N on node {}, the largest",
      unsupported.distance, unsupported.node + 1);
}

[[noreturn]] void refuse_overflow(const std::string& what) {
  throw InputError("--displacements", "", "numbers that can be measured", what);
}

}  // namespace

Method imported_method(const std::string& label, const ImportedFields& fields) {
  check_label(label);
  Method method{.name = label,
                .description = "what another program computed",
                .source = "the user's files",
                .family = Family::measured,
                .follows_solver = false,
                .told = {{"source", "measured"},
                         {"displacements", sha256_of(fields.displacements)}}};
  if (!fields.forces.empty())
    method.told.emplace_back("forces", sha256_of(fields.forces));
  return method;
}

std::vector<std::string> contradictions(const Mesh& mesh, const Scene& scene,
                                        const ImportedFields& fields) {
  const auto prescribed = prescribed_components(mesh, scene);
  std::vector<std::string> all;
  if (const auto found = off_supports(mesh, scene, prescribed, fields.displacements))
    all.push_back(*found);
  if (const auto found = forces_without_support(mesh, prescribed, fields.forces))
    all.push_back(*found);
  return all;
}

CaseResult imported_case(const RunSettings& run, const std::string& label,
                         const ImportedFields& fields, MeshStore& meshes,
                         const Finished& finished) {
  RunSettings measured = run;
  measured.methods = {{.method = imported_method(label, fields)}};
  const std::vector<Request> all = requests(measured);
  const CaseSettings& settings = all.front().settings;
  const Mesh& mesh = meshes.mesh(settings.body);
  const auto found = contradictions(mesh, mechanical_scene(settings, mesh), fields);
  CaseResult own = judged(settings, mesh,
                          {.status = SolveStatus::ok,
                           .reason = fmt::format("{}", fmt::join(found, "; ")),
                           .displacements = fields.displacements,
                           .reactions = fields.forces,
                           .lever_arms = LeverArms::deformed,
                           .strain_energy = 0,  // not known, like what follows but:
                           .load_fraction = 1,
                           .steps = 0,
                           .force_evaluations = 0});
  if (own.status == Status::not_converged) refuse_overflow(own.reason);
  // Known to the study, which runs the reference only.
  const auto known = [&](const Request& request,
                         const std::string&) -> std::optional<CaseResult> {
    if (request.reference || request.settings.method.solve) return std::nullopt;
    return own;
  };
  CaseResult result = run_study(all, meshes, 1, finished, known).front();
  if (const auto name = not_finite(result.measures))
    refuse_overflow(*name + " overflows");
  return result;
}

}  // namespace springcheck
