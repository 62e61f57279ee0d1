#!/usr/bin/env bash
# A sweep that is killed several times, at moments drawn from a fixed seed, ends with the same cases
# and the same bits as one that is left alone; a second writer is refused with the first's id.
#   interrupted_sweep_test.sh SPRINGCHECK TIMES
set -euo pipefail
springcheck=$1
times=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "$1" >&2; exit 1; }
cat > sweep.toml <<'EOF'
scene = ["compression", "shearing", "torsion"]
method = ["mss-cf", "fem-stvk", "fem-hencky"]
nu = {from = 0, to = 0.49, count = 12}
cells = [6, 6, 6]
fields = true
EOF
"$springcheck" sweep sweep.toml --out whole.h5 >whole.log

RANDOM=1
for _ in $(seq 1 "$times"); do
  "$springcheck" sweep sweep.toml --out killed.h5 >killed.log 2>&1 &
  writer=$!
  sleep "$(printf '0.%03d' $((300 + RANDOM % 700)))"
  kill -9 "$writer" 2>/dev/null || true
  wait "$writer" 2>/dev/null || true
done
"$springcheck" sweep sweep.toml --out killed.h5 >killed.log
"$springcheck" merge whole.h5 killed.h5 >merge.log || fail "$(cat merge.log)"
[ "$(cat merge.log)" = "killed.h5: 0 cases added, 108 already there" ] || fail "$(cat merge.log)"

"$springcheck" sweep sweep.toml --out busy.h5 >busy.log &
writer=$!
for _ in $(seq 1 200); do
  [ -s busy.h5.lock ] && break
  sleep 0.02
done
status=0
"$springcheck" sweep sweep.toml --out busy.h5 >second.log 2>&1 || status=$?
kill -9 "$writer" 2>/dev/null || true
[ "$status" -eq 2 ] || fail "a second writer ended with status $status"
grep -q "process $writer is writing" second.log || fail "$(cat second.log)"
