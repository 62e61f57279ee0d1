#include <gmsh.h>
#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <sstream>

#include "meshing/basics/input_error.hpp"
#include "meshing/conformity.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/files/msh_reader.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/generators/uniform_number.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(msh_mutations_test)

namespace {

const OwnFolder directory;

/// A small mesh of all types in the four formats, as gmsh writes them.
std::vector<std::string> sound_files() {
  write_mesh(
      generate_block(
          {.size = {0.3, 0.2, 0.7}, .cells = {2, 2, 2}, .pattern = CellPattern::mixed}),
      directory / "ours.msh");
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open((directory / "ours.msh").string());
  std::vector<std::string> texts;
  for (const double version : {2.2, 4.1})
    for (const int is_binary : {0, 1}) {
      gmsh::option::setNumber("Mesh.MshFileVersion", version);
      gmsh::option::setNumber("Mesh.Binary", is_binary);
      gmsh::write((directory / "gmshs.msh").string());
      texts.push_back(text_of(directory / "gmshs.msh"));
    }
  gmsh::finalize();
  return texts;
}

class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    switch (below(7)) {
      case 0:
        return text.substr(0, below(text.size()));
      case 1:
        return without_line(text);
      case 2:
        return with_swapped_words(text);
      case 3:
        return with_word(text,
                         std::array{"99999999999999", "-1", "1e308", "nan", "0",
                                    "18446744073709551615", "x", "$Nodes"}[below(8)]);
      case 4:  // a flipped bit
        text[below(text.size())] ^= static_cast<char>(1U << below(8));
        return text;
      case 5:  // a huge binary number
        text.replace(below(text.size() - 8), 8, std::string(8, '\x7f'));
        return text;
      default:  // a part twice
        const std::size_t place = below(text.size());
        return text.insert(place, text.substr(place, below(200)));
    }
  }

 private:
  std::size_t below(std::size_t end) {
    return static_cast<std::size_t>(uniform_number(random_) * static_cast<double>(end));
  }

  std::string without_line(const std::string& text) {
    const std::size_t start = text.find('\n', below(text.size()));
    if (start == std::string::npos) return "";
    const std::size_t end = text.find('\n', start + 1);
    return text.substr(0, start) + (end == std::string::npos ? "" : text.substr(end));
  }

  /// The place where a word starts, and its length.
  std::pair<std::size_t, std::size_t> word(const std::string& text) {
    const std::size_t start = text.find_first_not_of(" \n", below(text.size() - 1));
    return {start, text.find_first_of(" \n", start) - start};
  }

  std::string with_swapped_words(std::string text) {
    auto [a, a_size] = word(text);
    auto [b, b_size] = word(text);
    if (a > b) {
      std::swap(a, b);
      std::swap(a_size, b_size);
    }
    if (a + a_size >= b) return text;
    const std::string first = text.substr(a, a_size), second = text.substr(b, b_size);
    return text.replace(b, b_size, first).replace(a, a_size, second);
  }

  std::string with_word(std::string text, const std::string& other) {
    const auto [start, size] = word(text);
    return text.replace(start, size, other);
  }

  std::mt19937_64 random_;
};

/// 1 GB more than the process has: what asks for more gets std::bad_alloc.
void limit_memory() {
  std::ifstream in("/proc/self/statm");
  rlim_t pages = 0;
  in >> pages;
  const rlim_t bytes = pages * 4096 + (rlim_t{1} << 30U);
  const rlimit limit{.rlim_cur = bytes, .rlim_max = RLIM_INFINITY};
  BOOST_TEST_REQUIRE(setrlimit(RLIMIT_AS, &limit) == 0);
}

}  // namespace

// There are 4 formats, 500 files each, and one to three mutations a file. Any other
// exception than InputError, a crash or a hang fails the test; a file that is read must
// be sound.
BOOST_AUTO_TEST_CASE(damaged_files_are_read_as_sound_meshes_or_refused) {
  const std::vector<std::string> texts = sound_files();
  limit_memory();
  int read = 0, refused = 0;
  for (std::size_t format = 0; format < texts.size(); ++format)
    for (unsigned seed = 0; seed < 500; ++seed) {
      Mutation mutate(seed);
      std::string text = texts[format];
      for (unsigned n = 0; n <= seed % 3 && text.size() > 100; ++n) text = mutate(text);
      const std::filesystem::path file = directory / "damaged.msh";
      std::ofstream(file, std::ios::binary) << text;
      BOOST_TEST_CONTEXT("format " << format << ", seed " << seed) {
        const auto start = std::chrono::steady_clock::now();
        try {
          const Mesh mesh = read_msh(file, 1);
          ++read;
          BOOST_TEST(mesh.volume() > 0);
          BOOST_CHECK_NO_THROW(check_conformity(mesh));
        } catch (const InputError& error) {
          ++refused;
          BOOST_TEST(std::string(error.what()).starts_with(file.string()));
          BOOST_TEST(std::string(error.what()).size() < 500U);
        } catch (const std::exception& error) {
          BOOST_ERROR("not an InputError: " << error.what());
        }
        // The time is to be short: they take a millisecond.
        const std::chrono::duration<double> time =
            std::chrono::steady_clock::now() - start;
        BOOST_TEST(time.count() < 2);
      }
    }
  // Neither is everything refused, as if nothing were read, nor everything let through.
  BOOST_TEST(read > 20);
  BOOST_TEST(refused > 1000);
}

BOOST_AUTO_TEST_SUITE_END()
