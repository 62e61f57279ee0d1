#pragma once

#include <mutex>
#include <string>

namespace springcheck {

/// gmsh with an empty model, silent, on one thread and with its random numbers fixed, so
/// that equal geometry gets equal meshes. It keeps global state and is not thread-safe:
/// one session at a time.
class GmshSession {
 public:
  explicit GmshSession(const std::string& model);
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
};

}  // namespace springcheck
