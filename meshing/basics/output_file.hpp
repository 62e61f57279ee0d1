#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace springcheck {

/// The place that the bytes of `file` go to: the target of a symbolic link, so that the
/// link stays one.
std::filesystem::path link_target(const std::filesystem::path& file);

/// Throws InputError unless `file` can be created, or overwritten as a regular file
/// (through a symbolic link: its target). Leaves no trace.
void check_writable(const std::filesystem::path& file);

/// Makes `file` appear whole or not at all: `write` makes a file of another name and the
/// same extension beside it, which is then renamed, or removed when `write` throws.
void write_whole(
    const std::filesystem::path& file,
    const std::function<void(const std::filesystem::path& unfinished)>& write);

/// write_whole through a stream; throws std::runtime_error when not all could be written.
void write_whole_stream(const std::filesystem::path& file,
                        const std::function<void(std::ostream&)>& write);

}  // namespace springcheck
