#pragma once

#include <filesystem>
#include <string>

namespace springcheck {

/// The processor's name as the machine calls it; "unknown" where it does not say.
std::string processor_name();

/// What the kernels are computed with here, and whose processor it is: "avx2
/// AuthenticAMD". The processors of each have approximate roots of their own: between two
/// of them figures differ by rounding.
std::string instructions();

/// Who sets the processor's frequency, as Linux tells: "governor performance, boost on";
/// "unknown" where it does not, as in most virtual machines. `root` is / but for tests.
std::string clock_policy(const std::filesystem::path& root = "/");

/// Eight digits that tell this machine from others with the same processor: of a hash of
/// the number that Linux has given it; empty where it has none.
std::string machine_digits();

}  // namespace springcheck
