#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/own_folder.hpp"

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Run {
  int status;
  std::string out, err;
};

using springcheck::text_of;

/// The folder in which the program runs; it is removed at the end.
extern const fs::path folder;

/// Runs springcheck with these arguments in a folder of the test's own, in a child of
/// this process, which has loaded the libraries: they are most of a short run's time.
/// Where it is started by another program (`before`) or the arguments need a shell, the
/// program of the environment variable SPRINGCHECK is run.
Run run_springcheck(const std::string& arguments, const std::string& before = "");

Json json_of(const std::string& arguments);

/// The first case that a command tells of.
Json result_of(const std::string& arguments);

std::size_t lines(const std::string& text);

void expect_bad_input(const std::string& arguments, const std::string& part_of_message);
