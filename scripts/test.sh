#!/usr/bin/env bash
# Installs what is missing, builds and runs the tests. --all: the slow ones too. Those of the
# documentation run by scripts/docs.sh --test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

labels=(--label-exclude "slow|docs")
case "${1:-}" in
  "") ;;
  --all) labels=(--label-exclude docs) ;;
  *) echo "usage: bash scripts/test.sh [--all]" >&2; exit 2 ;;
esac
bash scripts/install_packages.sh
bash scripts/install_packages.sh scripts/packages_for_tests.txt &  # while it builds
packages_for_tests=$!
trap wait EXIT
bash scripts/build.sh all
wait "$packages_for_tests"
# One more than processors: browsers often wait.
ctest --preset release --parallel "$(($(nproc) + 1))" "${labels[@]}"
