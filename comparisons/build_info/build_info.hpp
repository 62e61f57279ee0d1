#pragma once

namespace springcheck::build_info {

/// What the program was built of; written by BuildInfo.cmake at every build.
extern const char* const version;  // "1.2.3"
extern const char* const commit;   // abbreviated, "-dirty" with uncommitted changes
/// The revision of the numerics: figures of programs of one revision are the same but for
/// rounding (Revision.cmake).
extern const char* const revision;
extern const char* const compiler;
extern const char* const flags;  // of the compiler, but those of warnings and kernels
extern const char* const deal_ii_version;
extern const char* const eigen_version;
extern const char* const hdf5_version;

}  // namespace springcheck::build_info
