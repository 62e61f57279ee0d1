#include "comparisons/command_line/options.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <thread>

namespace springcheck {
namespace {

constexpr int most_threads = 1024;

/// nullopt unless the whole text is a number.
std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

std::string refusal_of_seconds(const std::string& text) {
  const std::optional<double> seconds = number_in(text);
  return seconds && *seconds >= 0
             ? ""
             : "expected a number of seconds, 0 or more, got '" + text + "'";
}

std::string refusal_of_positive_seconds(const std::string& text) {
  const std::optional<double> seconds = number_in(text);
  return seconds && *seconds > 0
             ? ""
             : "expected a number of seconds above 0, got '" + text + "'";
}

}  // namespace

std::string alternatives(const std::vector<std::string_view>& names) {
  return fmt::format("{}", fmt::join(names, "|"));
}

std::string refusal_of_path(const std::string& text) {
  return text.empty() ? "expected a path, got ''" : "";
}

CLI::Option* add_format(CLI::App& parser, std::optional<TableFormat>& format,
                        const std::string& otherwise) {
  return add_choice<TableFormat>(parser, "--format", format,
                                 "of what is printed (default: " + otherwise + ")")
      ->group(of_output);
}

void add_formats(CLI::App& parser, std::optional<TableFormat>& format) {
  CLI::Option* const asked = add_format(parser, format, "text for people");
  parser
      .add_flag_callback(
          "--json", [&format] { format = TableFormat::json; },
          "print one JSON document, as --format json does")
      ->group(of_output)
      ->excludes(asked);
}

CLI::Option* add_threads(CLI::App& parser, int& threads) {
  return add_count(parser, "--threads", threads, 1, most_threads,
                   "at most this many (default: all cores)");
}

CLI::Option* add_jobs(CLI::App& parser, int& jobs, const std::string& what) {
  return add_count(parser, "--jobs", jobs, 1, most_threads,
                   what + " at once, at most (default: all cores)");
}

CLI::Option* add_seconds(CLI::App& parser, const std::string& option, double& seconds,
                         bool may_be_zero, const std::string& help) {
  return parser.add_option(option, seconds, help)
      ->check(may_be_zero ? refusal_of_seconds : refusal_of_positive_seconds)
      ->type_name("SECONDS")
      ->capture_default_str();
}

int all_cores() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace springcheck
