#include "statics/systems/aggregation.hpp"

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <ml_MultiLevelPreconditioner.h>
#include <ml_operator.h>
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>

#include "meshing/basics/random_numbers.hpp"

namespace springcheck::statics {
namespace {

void start_mpi() {
  int started = 0;
  MPI_Initialized(&started);
  if (started != 0) return;
  // One process needs no daemon beside it (Open MPI; others ignore the variable).
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  std::atexit([] { MPI_Finalize(); });
}

std::unique_ptr<Epetra_CrsMatrix> epetra_copy(const RowMatrix& matrix) {
  const int size = static_cast<int>(matrix.rows());
  const Epetra_Map map(size, 0, Epetra_MpiComm(MPI_COMM_SELF));
  std::vector<int> entries(static_cast<std::size_t>(size));
  const int* start = matrix.outerIndexPtr();
  for (int row = 0; row < size; ++row)
    entries[static_cast<std::size_t>(row)] = start[row + 1] - start[row];
  auto copy = std::make_unique<Epetra_CrsMatrix>(Copy, map, entries.data(), true);
  for (int row = 0; row < size; ++row)
    copy->InsertGlobalValues(row, start[row + 1] - start[row],
                             matrix.valuePtr() + start[row],
                             matrix.innerIndexPtr() + start[row]);
  copy->FillComplete();
  return copy;
}

RowMatrix copy_of(ML_Operator& from) {
  RowMatrix copy(from.outvec_leng, from.invec_leng);
  std::vector<int> columns(64);
  std::vector<double> values(columns.size());
  for (int row = 0; row < from.outvec_leng; ++row) {
    int count = 0;
    while (ML_Operator_Getrow(&from, 1, &row, static_cast<int>(columns.size()),
                              columns.data(), values.data(), &count) == 0) {
      columns.resize(2 * columns.size());
      values.resize(columns.size());
    }
    copy.startVec(row);
    std::vector<std::pair<int, double>> entries;
    for (int k = 0; k < count; ++k)
      entries.emplace_back(columns[static_cast<std::size_t>(k)],
                           values[static_cast<std::size_t>(k)]);
    std::ranges::sort(entries);
    for (const auto& [column, value] : entries)
      copy.insertBackByOuterInner(row, column) = value;
  }
  copy.finalize();
  return copy;
}

}  // namespace

Aggregation aggregation(RowMatrix matrix, const Eigen::MatrixXd& near_null_space) {
  const std::lock_guard lock(random_numbers());
  start_mpi();
  Eigen::MatrixXd motions = near_null_space;  // ML wants to write to it
  Teuchos::ParameterList settings;
  ML_Epetra::SetDefaults("SA", settings);
  settings.set("ML output", 0);
  settings.set("PDE equations", 3);
  settings.set("aggregation: type", "Uncoupled");
  settings.set("aggregation: threshold", 0.0);
  // This is a bound on the largest eigenvalue of D^-1 A instead of estimates that start
  // at random; it is about 1.9 times too high, so that 2.5 of it is 4/3 of the
  // eigenvalue.
  settings.set("eigen-analysis: type", "Anorm");
  settings.set("aggregation: damping factor", 2.5);
  // The library's own cycle is not used.
  settings.set("smoother: type", "do-nothing");
  settings.set("coarse: type", "do-nothing");
  settings.set("coarse: max size", 2000);
  settings.set("null space: type", "pre-computed");
  settings.set("null space: dimension", static_cast<int>(motions.cols()));
  settings.set("null space: vectors", motions.data());
  settings.set("null space: add default vectors", false);

  Aggregation levels;
  {
    const auto finest = epetra_copy(matrix);
    const ML_Epetra::MultiLevelPreconditioner hierarchy(*finest, settings, true);
    const ML& ml = *hierarchy.GetML();
    for (int level = 1; level < ml.ML_num_actual_levels; ++level) {
      levels.prolongations.push_back(copy_of(ml.Pmat[level]));
      levels.matrices.push_back(copy_of(ml.Amat[level]));
    }
  }
  levels.matrices.insert(levels.matrices.begin(), std::move(matrix));
  return levels;
}

}  // namespace springcheck::statics
