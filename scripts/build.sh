#!/usr/bin/env bash
# Installs what is missing and builds in build/release, quick when nothing changed: the
# program, or the targets that are named (all: tests and benchmark too).
# SPRINGCHECK_WERROR=ON in the environment: warnings end the build, from then on (OFF
# ends that).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/install_packages.sh
cmake --preset release -Wno-dev --log-level=WARNING \
  ${SPRINGCHECK_WERROR:+-DSPRINGCHECK_WERROR="$SPRINGCHECK_WERROR"} >&2
cmake --build --preset release --target "${@:-springcheck}" -- -j "$(nproc)" >&2
