#include "comparisons/store/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
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

#include "meshing/basics/input_error.hpp"
#include "meshing/basics/sha256.hpp"

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
  /// Reserves room that later writes are sure of.
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

std::string_view bytes_of(const Page& page) {
  return {page.data(), page.size()};
}

/// A file's pages as they are, zeros beyond its end.
class PageReader {
 public:
  explicit PageReader(const std::filesystem::path& file) : in_(file, std::ios::binary) {}
  std::string hash(std::uint64_t number) {
    Page page{};
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(number * page_size));
    in_.read(page.data(), page_size);
    return sha256(bytes_of(page));
  }

 private:
  std::ifstream in_;
};

std::string journal_text(const std::filesystem::path& file, const PageWrites& writes) {
  PageReader old(file);
  std::string bytes = magic();
  append(bytes, writes.file_size);
  append(bytes, writes.pages.size());
  for (const auto& [number, page] : writes.pages) {
    append(bytes, number);
    bytes += old.hash(number);
    bytes += bytes_of(page);
  }
  return bytes + sha256(bytes);
}

/// A journal's content.
struct Journal {
  PageWrites writes;
  std::map<std::uint64_t, std::string> old_hashes;
};

/// A journal's content; none unless it is whole.
std::optional<Journal> read_journal(std::string_view bytes) {
  if (bytes.size() < magic_size + 16 + hash_size || !bytes.starts_with(magic()))
    return std::nullopt;
  const std::string_view content = bytes.substr(0, bytes.size() - hash_size);
  if (bytes.substr(content.size()) != sha256(content)) return std::nullopt;
  bytes = content.substr(magic_size);
  Journal journal;
  journal.writes.file_size = take(bytes);
  const std::uint64_t count = take(bytes);
  if (bytes.size() != count * (8 + hash_size + page_size)) return std::nullopt;
  while (!bytes.empty()) {
    const std::uint64_t number = take(bytes);
    journal.old_hashes[number] = bytes.substr(0, hash_size);
    bytes.remove_prefix(hash_size);
    std::memcpy(journal.writes.pages[number].data(), bytes.data(), page_size);
    bytes.remove_prefix(page_size);
  }
  return journal;
}

/// Whether each page of the file is as it was before, or as it is to be.
bool belongs_to(const Journal& journal, const std::filesystem::path& file) {
  PageReader present(file);
  return std::ranges::all_of(journal.writes.pages, [&](const auto& entry) {
    const auto& [number, page] = entry;
    const std::string hash = present.hash(number);
    return hash == journal.old_hashes.at(number) || hash == sha256(bytes_of(page));
  });
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

void sync_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  const int number = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (number < 0) fail(folder, "cannot be opened");
  fsync(number);  // where a file system cannot, nothing is to be done
  close(number);
}

void write_pages_of_new_file(const std::filesystem::path& file,
                             const PageWrites& writes) {
  apply(file, writes);
}

void write_pages(const std::filesystem::path& file, const PageWrites& writes) {
  const std::filesystem::path journal = journal_of(file);
  const std::uint64_t old_size = std::filesystem::file_size(file);
  try {
    Descriptor(file, O_WRONLY).reserve(writes.file_size);
    const Descriptor out(journal, O_WRONLY | O_CREAT | O_TRUNC);
    out.write_at(0, journal_text(file, writes));
    out.sync();
    sync_folder_of(journal);
  } catch (...) {
    std::error_code ignored;  // the first failure is the one to report
    std::filesystem::remove(journal, ignored);
    std::filesystem::resize_file(file, old_size, ignored);  // what was reserved
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
  if (const auto whole = read_journal(bytes.view())) {
    if (!belongs_to(*whole, file))
      throw InputError(journal.string(), "", "the journal of " + file.string(),
                       "one of other content (was the file replaced? move it away)");
    apply(file, whole->writes);
  }
  std::filesystem::remove(journal);
}

}  // namespace springcheck
