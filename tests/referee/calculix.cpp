#include "tests/referee/calculix.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <sys/wait.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace referee {
namespace {

namespace fs = std::filesystem;

// CalculiX sets residuals below 1e-6 to zero, whatever the unit, and takes that for
// convergence; the forces on our nodes are millinewtons. In metres and micronewtons,
// stresses in micropascals, it iterates as far as it is told.
constexpr double micro = 1e-6;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// 14 digits: CalculiX reads 20 characters of a number.
std::string number(double x) {
  return fmt::format("{:.13e}", x);
}

void append(const fs::path& mesh_file, const Problem& problem) {
  std::ofstream out(mesh_file, std::ios::app);
  fmt::print(out,
             "*MATERIAL, NAME=tissue\n*ELASTIC\n{}, {}\n"
             "*SOLID SECTION, ELSET=Eall, MATERIAL=tissue\n",
             number(problem.young_modulus / micro), number(problem.poisson_ratio));
  if (problem.kinematics == Kinematics::nlgeom)
    // Residual below 1e-9 of the mean force, last correction below 1e-6 of the step; the
    // defaults are .005 and .01. The whole load is tried at once and cut when needed.
    fmt::print(out,
               "*STEP, NLGEOM, INC=1000\n*STATIC\n1, 1\n"
               "*CONTROLS, PARAMETERS=FIELD\n1e-9, 1e-6, , , 1e-9\n");
  else
    fmt::print(out, "*STEP\n*STATIC\n");
  fmt::print(out, "*BOUNDARY\n");
  for (const HeldSet& held : problem.held)
    for (int i = 0; i < 3; ++i)
      fmt::print(out, "{}, {}, {}, {}\n", held.set, i + 1, i + 1,
                 number(held.displacement[i]));
  for (const Pressure& pressure : problem.pressures)
    fmt::print(out, "*DSLOAD\n{}, P, {}\n", pressure.surface,
               number(pressure.value / micro));
  fmt::print(out,
             "*NODE PRINT, NSET=Nall\nU\n"
             "*NODE PRINT, NSET={}, TOTALS=ONLY\nRF\n*END STEP\n",
             problem.reaction_of);
  out.close();
  if (!out) throw std::runtime_error(mesh_file.string() + ": could not be written");
}

/// Runs it, and throws unless it says that it finished. On one thread two runs are equal
/// to the bit; more would change the rounding, far behind the digits that are printed.
void run(const std::string& program, const fs::path& mesh_file) {
  const fs::path folder = mesh_file.parent_path(), log = folder / "ccx.log";
  const std::string command = fmt::format(
      "cd '{}' && env -u CCX_NPROC_EQUATION_SOLVER OMP_NUM_THREADS=1 {} -i {} "
      ">ccx.log 2>&1 </dev/null",
      folder.string(), program, mesh_file.stem().string());
  const int ended = std::system(command.c_str());
  const int status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  const std::string printed = text_of(log);
  if (status == 127)  // env's, when there is no such program
    throw std::runtime_error("CalculiX: cannot run '" + program +
                             "'; the Debian package calculix-ccx has it (bash "
                             "scripts/install_packages.sh scripts/packages_for_tests.txt)");
  if (status != 0 || !contains(printed, "Job finished") || contains(printed, "*ERROR"))
    throw std::runtime_error(fmt::format(
        "CalculiX: exit status {}, last lines:\n{}", status,
        printed.substr(printed.size() - std::min<std::size_t>(printed.size(), 1000))));
}

/// The numbers below the last heading that starts so; it has to be of the full load.
std::istringstream last_block(const std::string& dat, const std::string& heading) {
  const std::size_t start = dat.rfind(heading);
  if (start == std::string::npos)
    throw std::runtime_error("CalculiX: no '" + heading + "' in its .dat file");
  const std::size_t end = dat.find('\n', start);
  const std::string line = dat.substr(start, end - start);
  if (std::stod(line.substr(line.rfind(' '))) != 1)
    throw std::runtime_error("CalculiX: stopped before the full load: " + line);
  return std::istringstream(dat.substr(end));
}

}  // namespace

InpMesh read_inp(const fs::path& file) {
  enum class Block { nodes, cells, other } block = Block::other;
  InpMesh mesh;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("**")) continue;
    if (line.starts_with("*")) {
      block = line.starts_with("*NODE")                  ? Block::nodes
              : line.starts_with("*ELEMENT, TYPE=C3D8,") ? Block::cells
                                                         : Block::other;
      continue;
    }
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    std::size_t index = 0;
    numbers >> index;
    if (block == Block::nodes) {
      Vector3 x;
      numbers >> x[0] >> x[1] >> x[2];
      mesh.nodes.push_back(x);
    } else if (block == Block::cells) {
      std::array<std::size_t, 8> cell{};
      for (std::size_t& node : cell) {
        numbers >> node;
        --node;
      }
      mesh.cells.push_back(cell);
    }
    const std::size_t expected = block == Block::nodes   ? mesh.nodes.size()
                                 : block == Block::cells ? mesh.cells.size()
                                                         : index;
    if (!numbers || index != expected)
      throw std::runtime_error(file.string() + ": cannot read '" + line + "'");
  }
  return mesh;
}

double volume(const InpMesh& mesh, const std::vector<Vector3>& positions) {
  // Corners of C3D8 in the reference cube [-1, 1]^3.
  static const std::array<Vector3, 8> corner{{{-1, -1, -1},
                                              {1, -1, -1},
                                              {1, 1, -1},
                                              {-1, 1, -1},
                                              {-1, -1, 1},
                                              {1, -1, 1},
                                              {1, 1, 1},
                                              {-1, 1, 1}}};
  double sum = 0;
  for (const auto& cell : mesh.cells)
    for (const Vector3& point : corner) {
      const Vector3 xi = point / std::sqrt(3.);  // Gauss point, weight 1
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
      for (std::size_t a = 0; a < 8; ++a) {
        const Vector3 factor = Vector3::Ones() + corner[a].cwiseProduct(xi);
        const Vector3 gradient(corner[a].x() * factor.y() * factor.z() / 8,
                               corner[a].y() * factor.z() * factor.x() / 8,
                               corner[a].z() * factor.x() * factor.y() / 8);
        jacobian += positions[cell[a]] * gradient.transpose();
      }
      sum += jacobian.determinant();
    }
  return sum;
}

Equilibrium solve(const fs::path& mesh_file, const Problem& problem,
                  const std::string& program) {
  const std::size_t nodes = read_inp(mesh_file).nodes.size();
  append(mesh_file, problem);
  run(program, mesh_file);

  fs::path dat_file = mesh_file;
  const std::string dat = text_of(dat_file.replace_extension(".dat"));
  Equilibrium result{.displacements = std::vector<Vector3>(nodes),
                     .reaction = Vector3::Zero()};
  std::istringstream displacements = last_block(dat, " displacements (vx,vy,vz)");
  for (std::size_t n = 0; n < nodes; ++n) {
    std::size_t number_of_node = 0;
    Vector3& u = result.displacements[n];
    displacements >> number_of_node >> u[0] >> u[1] >> u[2];
    if (!displacements || number_of_node != n + 1)
      throw std::runtime_error(
          fmt::format("CalculiX: no displacement of node {}", n + 1));
  }
  std::istringstream total = last_block(dat, " total force (fx,fy,fz)");
  total >> result.reaction[0] >> result.reaction[1] >> result.reaction[2];
  if (!total) throw std::runtime_error("CalculiX: no total force in its .dat file");
  result.reaction *= micro;
  return result;
}

}  // namespace referee
