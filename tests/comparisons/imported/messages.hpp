#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

/// The message of the InputError that `read` throws, "accepted" where it throws none;
/// the file's folder is left out.
template <class Read>
std::string message_of(const std::filesystem::path& file, Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string folder = file.parent_path().string() + "/";
    for (auto at = message.find(folder); at != std::string::npos;
         at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }
  return "accepted";
}

inline void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace springcheck
