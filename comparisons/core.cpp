#include <fmt/format.h>

#include <string_view>

#include "comparisons/commands/command_line.hpp"
#include "comparisons/commands/commands.hpp"

// The program that computes, which `springcheck` starts. It prints, too, what that can
// tell by itself.
int main(int argc, char** argv) {
  using namespace std::literals;
  if (argc != 2 || argv[1] != "--declarations"sv)
    return springcheck::command_line(argc, argv);
  fmt::print("{}\n", text_of(springcheck::declarations()));
  return 0;
}
