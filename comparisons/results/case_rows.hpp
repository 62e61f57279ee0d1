#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/store/columns.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck {

/// A case as a row of a result file: key and identity, settings under the names of their
/// keys, reference, mesh, status, flags (with commas), reason, every measure, the
/// solver's effort; and the row of the file's provenance it belongs to. What a case has
/// not is left out.
Row row_of(const CaseResult& result, const Mesh& mesh, std::size_t provenance);

/// Throws InputError, naming the file, where there is no such status.
Status status_named(const std::string& name, const std::string& file);

/// How far a solver of ours came, and in how many steps.
struct Effort {
  double load_fraction;
  int steps, force_evaluations;
};

/// What a result file knows about a case, without fields.
struct StoredCase {
  std::string key{};  // in its file
  Status status;
  std::vector<Status> flags{};
  std::string reason;
  Measures measures{};
  std::optional<Effort> effort;  // none where another program's result was measured
  std::optional<int> linear_iterations{}, factorisations{};
  std::optional<double> dt{}, dt_limit{};
  std::string revision{};  // of the program that computed it, where another's
  std::string date{};      // of its session, where another's
};

/// The inverse of row_of. `file` is for messages. Throws InputError with the case's key
/// where something is missing, is no finite number or contradicts the status: a case has
/// a volume if and only if it ended in an equilibrium.
StoredCase stored_case(const Columns& cases, std::size_t row, const std::string& file);

/// The stored case as a CaseResult of this request, without fields; its key is that in
/// the file.
CaseResult with_stored(const Request& request, const StoredCase& stored);

}  // namespace springcheck
