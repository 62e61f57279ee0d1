#!/usr/bin/env bash
# Makes the Debian packages springcheck and libspringcheck-dev in build/packages: installs
# what is missing, builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/build.sh
cpack --config build/release/CPackConfig.cmake -B build/packages >&2
rm -rf build/packages/_CPack_Packages
ls build/packages/*.deb
