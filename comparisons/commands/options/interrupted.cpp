#include "comparisons/commands/options/interrupted.hpp"

#include <fmt/format.h>

namespace springcheck {

BeforeInterruption tell_that_it_goes_on(
    const std::optional<std::filesystem::path>& file) {
  return tell_what_is_kept(file, "The same command goes on from there.");
}

BeforeInterruption tell_what_is_kept(const std::optional<std::filesystem::path>& file,
                                     const std::string& how) {
  return tell_when_interrupted([=]() -> std::string {
    if (!file) return "Nothing is kept: --out FILE keeps what is computed.";
    if (std::error_code none; !std::filesystem::exists(*file, none))
      return "Nothing was kept yet.";
    return fmt::format("What was complete is in {}.{}{}", file->string(),
                       how.empty() ? "" : " ", how);
  });
}

}  // namespace springcheck
