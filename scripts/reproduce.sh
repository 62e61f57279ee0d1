#!/usr/bin/env bash
# Regenerates every comparison table and the report page: installs what is missing, builds,
# computes.
# Usage: bash scripts/reproduce.sh [--all] [FOLDER]     (default: results)
# --all: the tables split, laws and growth too, which take most of an hour on two cores.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
extent=()
if [ "${1:-}" = --all ]; then
  extent=(--all)
  shift
fi
out=$(realpath -m "${1:-$root/results}")

bash "$root/scripts/build.sh"
"$root/build/release/springcheck" reproduce --out "$out" "${extent[@]}"
