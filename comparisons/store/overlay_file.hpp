#pragma once

#include <hdf5.h>

#include <filesystem>

#include "comparisons/store/journal.hpp"

namespace springcheck {

/// A file whose writes by HDF5 stay in memory: the disk sees them all at once, by
/// write_pages, or never.
///
///     OverlayFile overlay(file);
///     { const auto root = overlay.open(); ... }   // closed before the commit
///     write_pages(file, overlay.writes());
class OverlayFile {
 public:
  /// Takes an existing file, whose present content shows through.
  explicit OverlayFile(const std::filesystem::path& file);
  ~OverlayFile();
  OverlayFile(const OverlayFile&) = delete;
  OverlayFile& operator=(const OverlayFile&) = delete;

  /// The HDF5 file for reading and writing, or a new one in place of the content. Throws
  /// std::runtime_error when the content is no HDF5 file.
  hid_t open();
  hid_t create();

  /// All writes since the construction.
  [[nodiscard]] const PageWrites& writes() const { return writes_; }

  // HDF5's driver calls these; they return false when the disk fails.
  bool read(std::uint64_t place, std::size_t size, char* bytes) const;
  bool write(std::uint64_t place, std::size_t size, const char* bytes);
  void resize(std::uint64_t size) { writes_.file_size = size; }
  [[nodiscard]] std::uint64_t size() const { return writes_.file_size; }

 private:
  bool read_disk(std::uint64_t place, std::size_t size, char* bytes) const;
  std::filesystem::path file_;
  int descriptor_;
  PageWrites writes_;
};

}  // namespace springcheck
