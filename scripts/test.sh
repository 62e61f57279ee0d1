#!/usr/bin/env bash
# Installs what is missing, builds and runs the tests. --all: the slow ones too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

labels=(--label-exclude slow)
case "${1:-}" in
  "") ;;
  --all) labels=() ;;
  *) echo "usage: bash scripts/test.sh [--all]" >&2; exit 2 ;;
esac
bash scripts/install_packages.sh
bash scripts/install_packages.sh scripts/packages_for_{tests,docs}.txt &  # while it builds
packages_for_tests=$!
trap wait EXIT
bash scripts/build.sh all
wait "$packages_for_tests"
# One more than processors: browsers often wait.
ctest --preset release --parallel "$(($(nproc) + 1))" "${labels[@]}"
