#include "comparisons/system/memory.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(memory_test)

namespace {

/// Files of Linux below a folder.
class Root {
 public:
  void put(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((own_.path / file).parent_path());
    std::ofstream(own_.path / file) << text;
  }
  [[nodiscard]] double room() const { return room_of_control_groups(own_.path); }

 private:
  OwnFolder own_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(without_control_groups_or_limits_the_room_is_infinite) {
  const Root root;
  BOOST_TEST(std::isinf(root.room()));
  root.put("proc/self/cgroup", "0::/user/job\n");
  BOOST_TEST(std::isinf(root.room()));
  root.put("sys/fs/cgroup/user/job/memory.max", "max\n");
  root.put("sys/fs/cgroup/user/job/memory.current", "1000\n");
  BOOST_TEST(std::isinf(root.room()));
}

// A batch system limits the job or what it is part of.
BOOST_AUTO_TEST_CASE(of_all_groups_above_the_one_with_least_room_counts) {
  const Root root;
  root.put("proc/self/cgroup", "0::/slurm/job/step\n");
  const std::string job = "sys/fs/cgroup/slurm/job/";
  root.put(job + "memory.max", "5000\n");
  root.put(job + "memory.current", "1500\n");
  BOOST_TEST(root.room() == 3500.);
  root.put(job + "step/memory.max", "4000\n");
  root.put(job + "step/memory.current", "1500\n");
  BOOST_TEST(root.room() == 2500.);
  root.put("sys/fs/cgroup/slurm/memory.max", "2000\n");
  root.put("sys/fs/cgroup/slurm/memory.current", "1990\n");
  BOOST_TEST(root.room() == 10.);
}

// Linux takes them back when somebody needs the memory.
BOOST_AUTO_TEST_CASE(cached_files_are_room) {
  const Root root;
  root.put("proc/self/cgroup", "0::/job\n");
  root.put("sys/fs/cgroup/job/memory.max", "5000\n");
  root.put("sys/fs/cgroup/job/memory.current", "4500\n");
  root.put("sys/fs/cgroup/job/memory.stat",
           "anon 3000\nfile 1500\ninactive_file 1200\nactive_file 300\n");
  BOOST_TEST(root.room() == 1700.);
}

BOOST_AUTO_TEST_CASE(groups_of_version_1_are_read) {
  const Root root;
  root.put("proc/self/cgroup", "9:name=systemd:/a\n4:cpu,memory:/docker/x\n0::/\n");
  const std::string group = "sys/fs/cgroup/memory/docker/x/memory.";
  root.put(group + "limit_in_bytes", "7000\n");
  root.put(group + "usage_in_bytes", "3000\n");
  root.put(group + "stat", "inactive_file 1\ntotal_inactive_file 500\n");
  BOOST_TEST(root.room() == 4500.);
}

// In a container the group's path is the one outside, and its files are those of the
// mount.
BOOST_AUTO_TEST_CASE(a_container_s_own_group_is_found) {
  const Root root;
  root.put("proc/self/cgroup", "0::/docker/0123\n");
  root.put("sys/fs/cgroup/memory.max", "3000\n");
  root.put("sys/fs/cgroup/memory.current", "5000\n");
  BOOST_TEST(root.room() == 0.);  // and no less
}

BOOST_AUTO_TEST_SUITE_END()
