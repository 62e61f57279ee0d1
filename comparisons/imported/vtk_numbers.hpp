#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace springcheck {

/// Real numbers of VTK's XML files.
enum class VtkReal { float32, float64 };

/// How a VTK XML file writes the numbers between the tags of a DataArray.
struct VtkEncoding {
  enum class Format { ascii, base64 } format;
  enum class Compression { none, zlib } compression;  // of base64
  std::size_t header_bytes;  // of each number in the header of base64, 4 or 8
  VtkReal type;
};

/// So many numbers of a DataArray from its text. Base64 holds, little-endian,
///
///     uncompressed   header: bytes; then these
///     zlib           header: blocks, bytes of a block, of the last one (0: a whole one),
///                    compressed bytes of each; then the blocks
///
/// with or without an end ('=') of base64 behind the header: VTK's and meshio's files.
/// `place` is for messages. Throws InputError where the text holds anything else.
std::vector<double> vtk_numbers(const std::string& place, std::string_view text,
                                const VtkEncoding& encoding, std::size_t count);

}  // namespace springcheck
