#pragma once

#include <filesystem>
#include <string>

namespace springcheck {

/// A folder of this test alone, removed with what is in it.
struct OwnFolder {
  OwnFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "test-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~OwnFolder() { std::filesystem::remove_all(path); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  std::filesystem::path path;
};

}  // namespace springcheck
