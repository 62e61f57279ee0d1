#!/usr/bin/env bash
# Regenerates every comparison table and the report page: installs what is missing, builds,
# computes. Interrupted, it goes on where it was.
# Usage: bash scripts/reproduce.sh [--quick | --all] [FOLDER]     (default: results)
# --quick: the five tests of the thesis alone, in two minutes after the build.
# --all: the tables split, laws and growth too, which take most of an hour on two cores.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
extent=()
case "${1:-}" in
  --quick | --all)
    extent=("$1")
    shift
    ;;
esac
if [ $# -gt 1 ] || [[ "${1:-}" == -* ]]; then
  echo "reproduce.sh: expected [--quick | --all] [FOLDER], got '$*'" >&2
  exit 2
fi
out=$(realpath -m -- "${1:-$root/results}")

# A compiler's step or a download may take a minute, in which nothing else is said.
echo "0 s: packages and build; on two cores about ten minutes the first time" >&2
(
  while sleep 10 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
    echo "still building, for ${SECONDS} s" >&2
  done
) </dev/null >/dev/null &
told=$!
trap 'kill "$told" 2>/dev/null || true' EXIT
bash "$root/scripts/build.sh"
trap - EXIT
kill "$told" 2>/dev/null || true
wait "$told" 2>/dev/null || true
"$root/build/release/springcheck" reproduce --out "$out" "${extent[@]}"
