#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck {

/// What another program computed on a mesh, one entry per node.
struct ImportedFields {
  std::vector<Vector3> displacements;  // [m]
  // Forces that the supports apply to the body [N]; empty where they are not known:
  std::vector<Vector3> forces{};
};

/// The method of that name whose model are these fields. Throws InputError where the
/// label is empty or the name of a method of ours, or is no UTF-8 on one line without
/// commas.
Method imported_method(const std::string& label, const ImportedFields& fields);

/// What contradicts the scene, in words: nodes that do not follow its supports by more
/// than 1e-6 of the smallest edge, and forces where it has no support. Empty where
/// nothing does.
std::vector<std::string> contradictions(const Mesh& mesh, const Scene& scene,
                                        const ImportedFields& fields);

/// The fields as a case of the run's scene, its methods aside: measured and judged, with
/// the deviations from the run's reference, which is computed. Equilibrium and stability
/// are not known: status is ok, inverted or wrinkled. Torques take the deformed lever
/// arms. `finished` is as in run_study. Throws InputError where measures overflow.
CaseResult imported_case(const RunSettings& run, const std::string& label,
                         const ImportedFields& fields, MeshStore& meshes,
                         const Finished& finished);

}  // namespace springcheck
