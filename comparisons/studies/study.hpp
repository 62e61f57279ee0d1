#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons/running/simulate.hpp"

namespace springcheck {

/// Supplies a result that is known already, by its key.
using KnownResult = std::function<std::optional<CaseResult>(const Request& request,
                                                            const std::string& key)>;

/// Called before the first and after each simulation, from any thread but one at a time.
using Finished = std::function<void(std::size_t done, std::size_t all)>;

/// Takes the result of a request, by its place among them, as soon as it is complete;
/// from any thread but one at a time.
using Deliver = std::function<void(std::size_t request, CaseResult&& result)>;

/// A simulation ended without an answer: the program's fault, not the body's.
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs every request that is not known. Simulations that several requests share,
/// references included, run once, `parallel` of them at a time, fewer where their
/// estimated memory would not fit; those that are known with their fields do not run,
/// unless another revision of the numerics computed them. Results are let go as soon as
/// no request needs them. What `deliver` throws ends the study. The requests of a
/// simulation that throws (see simulate) have the status error, with what was thrown as
/// the reason; the others run, and then the first is thrown: NoAnswer that names it. An
/// InputError is no result; it is thrown then, too.
void run_study(const std::vector<Request>& requests, MeshStore& meshes, int parallel,
               const Finished& finished, const KnownResult& known, const Deliver& deliver,
               const Watch& watch = {});

/// The same, with all results at the end, in the requests' order.
std::vector<CaseResult> run_study(const std::vector<Request>& requests, MeshStore& meshes,
                                  int parallel, const Finished& finished,
                                  const KnownResult& known = {}, const Watch& watch = {});

}  // namespace springcheck
