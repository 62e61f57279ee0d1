#!/usr/bin/env bash
# Regenerates every comparison table: installs what is missing, builds, computes.
# Usage: bash scripts/reproduce.sh [FOLDER]     (default: results)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$root/results}")

bash "$root/scripts/build.sh"
"$root/build/release/springcheck" reproduce --out "$out"
echo "Start with $out/summary.md"
