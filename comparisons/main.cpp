#include "comparisons/commands/command_line.hpp"

int main(int argc, char** argv) {
  return springcheck::command_line(argc, argv);
}
