#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>

namespace springcheck {

inline constexpr std::size_t page_size = 4096;  // [bytes]
using Page = std::array<char, page_size>;

/// New contents of a file's pages, by page number, and its new size [bytes].
struct PageWrites {
  std::map<std::uint64_t, Page> pages;
  std::uint64_t file_size = 0;
};

/// The path of a file's journal: FILE-journal.
std::filesystem::path journal_of(const std::filesystem::path& file);

/// Changes `file`, which must exist, wholly or not at all, also when the program is
/// killed or the power fails: the pages go to the journal, then to the file, then the
/// journal is removed. When it is killed before the journal is whole, the file has not
/// changed but for zeros behind its end, the room reserved; when later, recover() does
/// the rest. The caller keeps other writers away.
///
/// Throws std::runtime_error when the disk is full or fails; the file has not changed
/// then, or the journal is whole and kept.
///
/// The journal holds, with little-endian numbers of 64 bits: "springcheck journal 1\n",
/// zeros up to 32 bytes; the size of the file; the number of pages; for each page its
/// number, the SHA-256 of its old bytes (zeros beyond the old end) as 64 hexadecimal
/// digits, and its 4096 new bytes; the SHA-256 of all that likewise.
void write_pages(const std::filesystem::path& file, const PageWrites& writes);

/// Writes the pages of a file that nobody has use for before it is whole: straight to the
/// disk, and partly there when the program is killed.
void write_pages_of_new_file(const std::filesystem::path& file, const PageWrites& writes);

/// The folder's list of files goes to disk, too: what was renamed stays so.
void sync_folder_of(const std::filesystem::path& file);

/// What is left by a program that was killed: a whole journal is written to the file, and
/// any is removed. Throws as write_pages, and InputError when the journal is of other
/// content: when some page is neither as it was nor as it is to be. Both files stay then.
void recover(const std::filesystem::path& file);

}  // namespace springcheck
