#!/usr/bin/env bash
# Builds the documentation in build/docs: the site (index.html) and the reference of the
# headers (api/index.html). Warnings, among them links to pages that there are not, end it.
# Installs what is missing and builds the program, whose lists and help the site prints;
# with SPRINGCHECK=PROGRAM in the environment it takes that one, and does neither.
# Usage: bash scripts/docs.sh [--links | --test]
# --links: looks up other sites' addresses too. --test: builds the site as a test, beside
# those that run what README and documentation tell their readers to type.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

builders=(html)
what=site
case "${1:-}" in
  "") ;;
  --links) builders+=(linkcheck) ;;
  --test) what=tests ;;
  *) echo "usage: bash scripts/docs.sh [--links | --test]" >&2; exit 2 ;;
esac
if [ -z "${SPRINGCHECK:-}" ]; then
  bash scripts/build.sh
  bash scripts/install_packages.sh scripts/packages_for_docs.txt
  export SPRINGCHECK="$PWD/build/release/springcheck"
fi
if [ "$what" = tests ]; then
  bash scripts/install_packages.sh scripts/packages_for_tests.txt
  exec ctest --preset release --parallel "$(nproc)" --label-regex docs --label-exclude slow
fi
out=build/docs
mkdir -p "$out"
find "$out" -mindepth 1 -maxdepth 1 ! -name _images -exec rm -rf {} +  # formulas stay
doxygen docs/Doxyfile 2>build/docs-headers.txt &
headers=$!
for builder in "${builders[@]}"; do
  sphinx-build -q -W --keep-going -n -b "$builder" -d build/docs-pages docs "$out"
done
wait "$headers" || headers=failed
if [ "$headers" = failed ] || [ -s build/docs-headers.txt ]; then  # errors leave its status 0
  cat build/docs-headers.txt >&2
  exit 1
fi
echo "$out/index.html"
