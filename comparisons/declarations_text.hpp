#pragma once

namespace springcheck {

/// What `springcheck-core --declarations` prints, which is compiled into the program.
extern const char* const declarations_text;

}  // namespace springcheck
