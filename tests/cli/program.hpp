#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

// Runs the real program, whose path is in the environment variable SPRINGCHECK.

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Run {
  int status;
  std::string out, err;
};

std::string text_of(const fs::path& file);

/// Where the program runs; removed at the end.
extern const fs::path folder;

/// Runs springcheck with these arguments in a folder of the test's own.
Run springcheck(const std::string& arguments, const std::string& before = "");

Json json_of(const std::string& arguments);

std::size_t lines(const std::string& text);

void expect_bad_input(const std::string& arguments, const std::string& part_of_message);
