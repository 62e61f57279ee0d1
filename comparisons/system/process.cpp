#include "comparisons/system/process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include "comparisons/system/interruption.hpp"

namespace springcheck {
namespace {

std::runtime_error failure(const std::string& program, int error) {
  return std::runtime_error(program + ": " + std::generic_category().message(error));
}

/// Ends a program and waits until it has ended; its status stays for whoever asks for it.
void end_program(pid_t program) {
  kill(program, SIGTERM);
  siginfo_t info;
  while (waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
}

}  // namespace

int run_program(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t program = 0;
  const int error = posix_spawn(&program, arguments.front(), nullptr, nullptr,
                                arguments.data(), environ);
  if (error != 0) throw failure(words.front(), error);
  const BeforeInterruption end([program] { end_program(program); });
  int status = 0;
  while (waitpid(program, &status, 0) < 0)
    if (errno != EINTR) throw failure(words.front(), errno);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace springcheck
