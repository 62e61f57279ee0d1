#include "comparisons/results/result_writer.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(result_writer_test)

// What the writing throws reaches who puts results in or waits for the end.
BOOST_AUTO_TEST_CASE(a_failure_of_the_writer_is_not_lost) {
  const OwnFolder own;
  MeshStore meshes;
  const auto results = run_study(requests(run_of("compression", {"cells=2,2,2"})), meshes,
                                 1, [](std::size_t, std::size_t) {});
  fs::create_directory(own.path / "folder");
  ResultFile file(own.path / "folder" / "a.h5");
  fs::remove_all(own.path / "folder");
  ResultWriter writer(file, true, meshes);
  writer.put(CaseResult(results.front()));
  BOOST_CHECK_THROW(writer.finish(), std::exception);
  BOOST_CHECK_THROW(writer.put(CaseResult(results.front())), std::exception);
}

// When the study ends early, what was computed until then is not lost.
BOOST_AUTO_TEST_CASE(a_writer_that_goes_writes_what_waits) {
  const OwnFolder own;
  MeshStore meshes;
  const auto results =
      run_study(requests(run_of("compression", {"cells=2,2,2", "method=mss-cf,mss-fd"})),
                meshes, 1, [](std::size_t, std::size_t) {});
  ResultFile file(own.path / "a.h5");
  try {
    ResultWriter writer(file, true, meshes);
    for (const CaseResult& result : results) writer.put(CaseResult(result));
    throw std::runtime_error("a case without an answer");
  } catch (const std::runtime_error&) {
  }
  BOOST_TEST(read_cases(own.path / "a.h5", Revisions::own).rows == results.size());
}

BOOST_AUTO_TEST_SUITE_END()
