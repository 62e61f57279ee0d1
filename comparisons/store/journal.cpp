#include "comparisons/store/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t magic_size = 32, hash_size = 64;

std::string magic() {
  std::string text = "springcheck journal 1\n";
  text.resize(magic_size, '\0');
  return text;
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what) {
  throw std::runtime_error(file.string() + ": " + what + ": " +
                           std::generic_category().message(errno));
}

class Descriptor {
 public:
  Descriptor(std::filesystem::path file, int flags)
      : file_(std::move(file)), number_(open(file_.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) fail(file_, "cannot be opened for writing");
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write_at(std::uint64_t place, std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written =
          pwrite(number_, bytes.data(), bytes.size(), static_cast<off_t>(place));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(file_, "cannot be written");
      bytes.remove_prefix(static_cast<std::size_t>(written));
      place += static_cast<std::uint64_t>(written);
    }
  }
  /// Room that later writes are sure of.
  void reserve(std::uint64_t size) const {
    if (size == 0) return;
    errno = posix_fallocate(number_, 0, static_cast<off_t>(size));
    if (errno != 0) fail(file_, "has no room");
  }
  void resize(std::uint64_t size) const {
    if (ftruncate(number_, static_cast<off_t>(size)) != 0)
      fail(file_, "cannot be resized");
  }
  void sync() const {
    if (fsync(number_) != 0) fail(file_, "cannot be written to disk");
  }

 private:
  std::filesystem::path file_;
  int number_;
};

void append(std::string& bytes, std::uint64_t number) {
  std::array<char, sizeof number> raw{};
  std::memcpy(raw.data(), &number, sizeof number);
  bytes.append(raw.begin(), raw.end());
}

std::uint64_t take(std::string_view& bytes) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes.remove_prefix(sizeof number);
  return number;
}

std::string journal_text(const PageWrites& writes) {
  std::string bytes = magic();
  append(bytes, writes.file_size);
  append(bytes, writes.pages.size());
  for (const auto& [number, page] : writes.pages) {
    append(bytes, number);
    bytes.append(page.begin(), page.end());
  }
  return bytes + sha256(bytes);
}

/// None unless the journal is whole.
std::optional<PageWrites> read_journal(std::string_view bytes) {
  if (bytes.size() < magic_size + 16 + hash_size || !bytes.starts_with(magic()))
    return std::nullopt;
  const std::string_view content = bytes.substr(0, bytes.size() - hash_size);
  if (bytes.substr(content.size()) != sha256(content)) return std::nullopt;
  bytes = content.substr(magic_size);
  PageWrites writes;
  writes.file_size = take(bytes);
  const std::uint64_t count = take(bytes);
  if (bytes.size() != count * (8 + page_size)) return std::nullopt;
  while (!bytes.empty()) {
    Page& page = writes.pages[take(bytes)];
    std::memcpy(page.data(), bytes.data(), page_size);
    bytes.remove_prefix(page_size);
  }
  return writes;
}

void apply(const std::filesystem::path& file, const PageWrites& writes) {
  const Descriptor out(file, O_WRONLY);
  for (const auto& [number, page] : writes.pages)
    out.write_at(number * page_size, {page.data(), page_size});
  out.resize(writes.file_size);
  out.sync();
}

}  // namespace

std::filesystem::path journal_of(const std::filesystem::path& file) {
  return file.string() + "-journal";
}

void write_pages(const std::filesystem::path& file, const PageWrites& writes) {
  const std::filesystem::path journal = journal_of(file);
  try {
    Descriptor(file, O_WRONLY).reserve(writes.file_size);
    const Descriptor out(journal, O_WRONLY | O_CREAT | O_TRUNC);
    out.write_at(0, journal_text(writes));
    out.sync();
  } catch (...) {
    std::error_code ignored;  // the first failure is the one to report
    std::filesystem::remove(journal, ignored);
    throw;
  }
  apply(file, writes);
  std::filesystem::remove(journal);
}

void recover(const std::filesystem::path& file) {
  const std::filesystem::path journal = journal_of(file);
  if (!std::filesystem::exists(journal)) return;
  std::ostringstream bytes;
  bytes << std::ifstream(journal, std::ios::binary).rdbuf();
  if (const auto writes = read_journal(bytes.view())) apply(file, *writes);
  std::filesystem::remove(journal);
}

}  // namespace springcheck
