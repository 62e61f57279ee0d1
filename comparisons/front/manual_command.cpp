#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <ostream>
#include <system_error>

#include "comparisons/command_line/manual_page.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/front/front_commands.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

void write_page(const std::filesystem::path& file, const std::string& page) {
  write_whole_stream(file, [&](std::ostream& out) { out << page; });
}

/// Every page, as springcheck.1 and springcheck-COMMAND.1.
void write_all_pages(const std::filesystem::path& folder, const Declarations& all) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw InputError(folder.string(), "", "a folder that can be created",
                     failed.message());
  write_page(folder / "springcheck.1", manual_page(all.commands));
  for (const CommandText& command : all.commands)
    write_page(folder / fmt::format("springcheck-{}.1", command.name),
               manual_page(command));
}

Action declare_manual(CLI::App& parser, const Declarations& all) {
  struct Options {
    std::string command{};
    std::optional<std::filesystem::path> out{};
  };
  const auto options = std::make_shared<Options>();
  CLI::Option* const command =
      parser
          .add_option("command", options->command, "whose page it is (default: of all)")
          ->type_name("COMMAND");
  add_path(parser, "--out", options->out, "FOLDER", "folder for all pages instead")
      ->excludes(command);
  return [options, &all] {
    if (options->out)
      write_all_pages(*options->out, all);
    else
      fmt::print("{}", options->command.empty()
                           ? manual_page(all.commands)
                           : manual_page(command_named(options->command, all)));
    return ExitStatus::done;
  };
}

}  // namespace

Command manual_command(const Declarations& all) {
  return {.name = "manual",
          .summary = "Print manual pages for man",
          .description = "The installed package has them already.",
          .examples = {{"springcheck manual run | man -l -", "reads the page of run"},
                       {"springcheck manual --out man1", "writes every page"}},
          .declare = [&all](CLI::App& parser) { return declare_manual(parser, all); }};
}

}  // namespace springcheck
