#pragma once

#include <string>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/measures/history.hpp"
#include "comparisons/measures/measures.hpp"

namespace springcheck {

struct CaseResult {
  Request request;
  std::string key{};  // identifies all that determines the result, see case_key
  Status status;
  // All of wrinkled, indefinite, inverted and extrapolated that apply:
  std::vector<Status> flags{};
  std::string reason{};  // why in words; with ok and no flag what else is to be known
  Measures measures{};   // all empty when there is no equilibrium to measure
  Solution solution{};
  // Displacement of each node less the reference's [m]; empty without a reference:
  std::vector<Vector3> deviation{};
  History history{};       // of dynamics, where samples were asked for
  HistoryFrames frames{};  // the body at some of them
  // The revision of the numerics that it was computed with, where they are not this
  // program's alone; "a+b" for a motion that revision a began and b went on with:
  std::string revision{};
};

/// SHA-256 of settings, reference and mesh: what was asked.
std::string case_identity(const Request& request, const Mesh& mesh);
std::string case_identity(const Request& request, const std::string& mesh_sha256);

/// SHA-256 of an identity and a revision of the numerics, this program's where none is
/// given: what its figures are stored under.
std::string key_of_identity(const std::string& identity,
                            const std::string& revision = "");
std::string case_key(const Request& request, const Mesh& mesh);

/// The revisions whose stored figures are taken: this program's, or others as well, where
/// there are none of this one.
enum class Revisions { own, all };

/// The status and flags of a case. Failed solutions keep the solver's word; others have
/// the first that applies of inverted (a corner Jacobian below 0), wrinkled, indefinite,
/// ok.
struct Verdict {
  Status status;
  std::vector<Status> flags{};
};
Verdict judge(SolveStatus solved, bool inverted, bool wrinkled);

/// The status and the flags beside it, in words.
std::string status_words(const CaseResult& result);

}  // namespace springcheck
