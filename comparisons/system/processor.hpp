#pragma once

#include <filesystem>
#include <string>

namespace springcheck {

/// As the machine calls it; "unknown" where it does not say.
std::string processor_name();

/// "avx2 AuthenticAMD": what the kernels are computed with here, and whose processor,
/// since those of each have approximate roots of their own. Between two of them figures
/// differ by rounding.
std::string instructions();

/// Who sets the processor's frequency, as Linux tells: "governor performance, boost on";
/// "unknown" where it does not, as in most virtual machines. `root` is / but for tests.
std::string clock_policy(const std::filesystem::path& root = "/");

/// Eight digits that tell this machine from others with the same processor: of a hash of
/// the number that Linux has given it; empty where it has none.
std::string machine_digits();

}  // namespace springcheck
