#include "comparisons/studies/study.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <new>
#include <set>
#include <span>

#include "comparisons/running/memory.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/studies/converged.hpp"
#include "comparisons/system/memory.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck {
namespace {

/// A case that runs once, however many requests need it.
struct Simulation {
  CaseSettings settings;
  const Mesh* mesh;
  std::optional<CaseResult> result;
  std::vector<std::size_t> requests;  // that wait for it
  std::size_t users;                  // requests that have yet to read it
};

/// What a request is made of.
struct Parts {
  std::size_t simulation;
  std::vector<std::size_t> reference;
  std::size_t missing;  // of these, not yet simulated

  [[nodiscard]] std::vector<std::size_t> all() const {
    std::vector<std::size_t> places{simulation};
    places.insert(places.end(), reference.begin(), reference.end());
    return places;
  }
};

/// Lets simulations start while their estimated memory fits; one alone always may.
class MemoryBudget {
 public:
  explicit MemoryBudget(double bytes) : free_(bytes) {}

  void take(double bytes) {
    std::unique_lock lock(mutex_);
    released_.wait(lock, [&] { return running_ == 0 || bytes <= free_; });
    free_ -= bytes;
    ++running_;
  }
  void give(double bytes) {
    {
      const std::lock_guard lock(mutex_);
      free_ += bytes;
      --running_;
    }
    released_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable released_;
  double free_;
  int running_ = 0;
};

std::vector<Vector3> difference(std::vector<Vector3> a, const std::vector<Vector3>& b) {
  for (std::size_t n = 0; n < a.size(); ++n) a[n] -= b[n];
  return a;
}

/// Why a case that is measured has no deviation; empty where none was wanted.
std::string why_no_deviation(const Request& request,
                             std::span<const CaseResult* const> reference) {
  for (const CaseResult* run : reference)
    if (!run->measures.volume_error)
      return fmt::format("no deviation, the reference {} is {}{}{}",
                         reference_label(request), name_of(run->status),
                         run->reason.empty() ? "" : ": ", run->reason);
  return request.no_reference;
}

/// Runs the simulations of a study, many at a time, and hands over what they make.
class StudyRun {
 public:
  StudyRun(const std::vector<Request>& requests, MeshStore& meshes,
           const KnownResult& known, const Deliver& deliver, const Watch& watch)
      : requests_(requests),
        meshes_(meshes),
        known_(known),
        deliver_(deliver),
        watch_(watch) {
    for (std::size_t i = 0; i < requests.size(); ++i) plan(i);
  }

  void run(int parallel, const Finished& finished) {
    finished(0, to_run_.size());
    for (const std::size_t request : ready_) complete(request);
    std::size_t done = 0;
    MemoryBudget budget(available_memory());
    const auto run_one = [&](std::size_t i) {
      // An exception that leaves here would cancel the loops inside other simulations,
      // which would go on with what these had not computed.
      if (not_taken_) return;
      std::exception_ptr failure;
      try {
        simulate_one(to_run_[i], budget);
      } catch (...) {
        failure = std::current_exception();
      }
      const std::lock_guard lock(finishing_);
      if (failure) failures_.emplace(to_run_[i], failure);
      finished(++done, to_run_.size());
    };
    const auto all_threads = static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    threads_ = std::max(1, all_threads / parallel);
    if (parallel == 1) {  // outside of an arena of one thread: inner loops have them all
      for (std::size_t i = 0; i < to_run_.size(); ++i) run_one(i);
    } else {
      tbb::task_arena arena(parallel);
      arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, to_run_.size(), 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
              for (std::size_t i = range.begin(); i < range.end(); ++i) run_one(i);
            },
            tbb::simple_partitioner());
      });
    }
    if (not_taken_) std::rethrow_exception(refusal_);
    if (failures_.empty()) return;
    for (const auto& [place, failure] : failures_) deliver_without_answer(place, failure);
    if (not_taken_) std::rethrow_exception(refusal_);
    rethrow_first();
  }

 private:
  void plan(std::size_t i) {
    const Request& request = requests_[i];
    parts_.emplace_back();
    if (known_) {
      const Mesh& mesh = meshes_.mesh(request.settings.body);
      if (auto result = known_(request, case_key(request, mesh))) {
        deliver_(i, std::move(*result));
        return;
      }
    }
    Parts& parts = parts_.back();
    parts.simulation = place_of(request.settings);
    for (const CaseSettings& settings : reference_cases(request))
      parts.reference.push_back(place_of(settings));
    for (const std::size_t place : parts.all()) {
      Simulation& simulation = simulations_[place];
      ++simulation.users;
      if (simulation.result) continue;
      simulation.requests.push_back(i);
      ++parts.missing;
    }
    if (parts.missing == 0) ready_.push_back(i);
  }

  /// What a simulation threw, in words. Throws it where it is an InputError.
  [[nodiscard]] std::string words_of(std::size_t place,
                                     const std::exception_ptr& failure) const {
    const CaseSettings& settings = simulations_[place].settings;
    std::string why;
    try {
      std::rethrow_exception(failure);
    } catch (const InputError&) {
      throw;
    } catch (const std::bad_alloc&) {
      why = fmt::format("the memory is not enough (about {:.2g} GB by estimate)",
                        estimated_memory(settings) / 1e9);
    } catch (const std::exception& error) {
      why = error.what();
    }
    return "no answer, " + why;
  }

  /// Throws the failure of the simulation that was planned first.
  [[noreturn]] void rethrow_first() const {
    const auto& [place, failure] = *failures_.begin();
    throw NoAnswer(fmt::format(
        "{}: {}; {} of {} simulations ended so", label(simulations_[place].settings),
        words_of(place, failure), failures_.size(), to_run_.size()));
  }

  /// Delivers a result without an answer to the requests that wait for a simulation, each
  /// once.
  void deliver_without_answer(std::size_t place, const std::exception_ptr& failure) {
    const std::string reason = words_of(place, failure);
    for (const std::size_t i : simulations_[place].requests) {
      if (!without_answer_.insert(i).second) continue;
      const Mesh& mesh = meshes_.mesh(requests_[i].settings.body);
      hand_over(i, {.request = requests_[i],
                    .key = case_key(requests_[i], mesh),
                    .status = Status::error,
                    .reason = reason,
                    .measures = {.wall_s = 0, .solve_wall_s = 0}});
    }
  }

  /// The place of a case's simulation, which is known by its key without a reference.
  /// Results of other revisions are taken whole or not at all: nothing of this one is
  /// made of them.
  std::size_t place_of(const CaseSettings& settings) {
    const Mesh& mesh = meshes_.mesh(settings.body);
    const Request alone{.settings = settings};
    const std::string key = case_key(alone, mesh);
    const auto [place, is_new] = places_.try_emplace(key, simulations_.size());
    if (!is_new) return place->second;
    simulations_.push_back({settings, &mesh, std::nullopt, {}, 0});
    auto result = known_ ? known_(alone, key) : std::nullopt;
    if (result && result->revision.empty() && !result->solution.displacements.empty())
      simulations_.back().result = std::move(*result);
    else
      to_run_.push_back(place->second);
    return place->second;
  }

  void simulate_one(std::size_t place, MemoryBudget& budget) {
    Simulation& simulation = simulations_[place];
    const double bytes = estimated_memory(simulation.settings);
    budget.take(bytes);
    CaseResult result;
    try {
      // The simulation is isolated: a thread that waits for its own inner loops must not
      // start another simulation meanwhile, whose time would count twice.
      result = tbb::this_task_arena::isolate([&] {
        return simulate(simulation.settings, *simulation.mesh, threads_, watch_);
      });
    } catch (...) {
      budget.give(bytes);
      throw;
    }
    budget.give(bytes);

    std::vector<std::size_t> ready;
    {
      const std::lock_guard lock(planning_);
      simulation.result = std::move(result);
      for (const std::size_t request : simulation.requests)
        if (--parts_[request].missing == 0) ready.push_back(request);
    }
    std::exception_ptr failure;
    for (const std::size_t request : ready) {
      try {
        complete(request);
      } catch (...) {
        failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
  }

  /// Measures the deviations of a request whose simulations are all there.
  void complete(std::size_t i) {
    const Request& request = requests_[i];
    const Parts& parts = parts_[i];
    const Simulation& own = simulations_[parts.simulation];
    CaseResult result = *own.result;
    std::vector<const CaseResult*> runs;
    for (const std::size_t place : parts.reference)
      runs.push_back(&*simulations_[place].result);
    if (const auto reference = reference_field(request, runs, meshes_);
        reference && result.measures.volume_error) {
      measure_deviation(result.measures, request.settings, *own.mesh, result.solution,
                        reference->solution);
      result.deviation =
          difference(result.solution.displacements, reference->solution.displacements);
      result.measures.reference_order = reference->order;
      result.measures.reference_bar = reference->error_bound;
      if (reference->error_bound)
        result.measures.reference_bar_l2_relative = reference_bar_l2_relative(
            at_largest_load(request.settings, result.solution.load_fraction), *own.mesh,
            reference->solution, reference->node_error_bounds);
    }
    if (result.measures.volume_error && !result.measures.mean_deviation)
      add_reason(result.reason, why_no_deviation(request, runs));
    result.request = request;
    result.key = key_of_identity(case_identity(request, *own.mesh), result.revision);
    hand_over(i, std::move(result));
    const std::lock_guard lock(planning_);
    for (const std::size_t place : parts.all())
      if (--simulations_[place].users == 0) simulations_[place].result.reset();
  }

  void hand_over(std::size_t i, CaseResult&& result) {
    const std::lock_guard lock(finishing_);
    if (not_taken_) return;
    try {
      deliver_(i, std::move(result));
    } catch (...) {
      refusal_ = std::current_exception();
      not_taken_ = true;
    }
  }

  const std::vector<Request>& requests_;
  MeshStore& meshes_;
  const KnownResult& known_;
  const Deliver& deliver_;
  const Watch& watch_;
  int threads_ = 1;  // of each simulation
  std::vector<Simulation> simulations_;
  std::vector<Parts> parts_;  // of the requests
  std::map<std::string, std::size_t> places_;
  std::vector<std::size_t> to_run_, ready_;
  std::mutex planning_, finishing_;
  std::map<std::size_t, std::exception_ptr> failures_;  // by the simulation's place
  std::set<std::size_t> without_answer_;                // requests, for one of these
  std::atomic<bool> not_taken_ = false;                 // a result, by deliver
  std::exception_ptr refusal_;                          // what it threw
};

}  // namespace

void run_study(const std::vector<Request>& requests, MeshStore& meshes, int parallel,
               const Finished& finished, const KnownResult& known, const Deliver& deliver,
               const Watch& watch) {
  StudyRun(requests, meshes, known, deliver, watch).run(parallel, finished);
}

std::vector<CaseResult> run_study(const std::vector<Request>& requests, MeshStore& meshes,
                                  int parallel, const Finished& finished,
                                  const KnownResult& known, const Watch& watch) {
  std::vector<CaseResult> results(requests.size());
  const Deliver keep = [&](std::size_t request, CaseResult&& result) {
    results[request] = std::move(result);
  };
  run_study(requests, meshes, parallel, finished, known, keep, watch);
  return results;
}

}  // namespace springcheck
