#!/usr/bin/env bash
# Installs what is missing and builds build/release; quick when nothing changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/install_packages.sh
cmake --preset release -Wno-dev --log-level=WARNING >&2
cmake --build --preset release -- -j "$(nproc)" >&2
