#!/usr/bin/env bash
# The workflow on two cores, one job of which is killed in the middle: the next run goes on with
# what the job had written, and the merged file holds every case.
#   workflow_test.sh SPRINGCHECK SNAKEFILE
set -euo pipefail
springcheck=$1 snakefile=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/a folder"
cd "$folder/a folder"
cat > sweep.toml <<'EOF'
scene = "compression"
method = "fem-stvk"
reference = "fem-stvk"
cells = [14, 14, 14]
nu = {from = 0.1, to = 0.4, count = 12}
EOF
shards="my all.h5.shards/sweep-2"
run() {
  snakemake --snakefile "$snakefile" --cores 2 --rerun-incomplete --keep-going --nolock --quiet all \
    --config sweep=sweep.toml out="my all.h5" shards=2 springcheck="$springcheck" "$@"
}
fail() { echo "$1" >&2; exit 1; }
command -v snakemake > /dev/null ||
  fail "there is no snakemake (bash scripts/install_packages.sh scripts/packages_for_tests.txt)"

run > first.log 2>&1 &
first=$!
kept() { "$springcheck" sweep sweep.toml --out "$shards/1.h5" --shard 1/2 --dry-run; }
for _ in $(seq 1 600); do  # until the first shard has a case
  [ -s "$shards/1.h5" ] && kept > kept.log 2>&1 && ! grep -q "6 of them" kept.log && break
  sleep 0.1
done
pkill -9 -f -- "--out $shards/1.h5" || fail "no job to kill"
if wait "$first"; then fail "the killed job went unnoticed"; fi
[ -s "$shards/1.h5" ] || fail "the killed job's result file is lost"
[ ! -e "my all.h5" ] || fail "merged before all shards were done"
kept > kept.log
grep -q "6 cases, " kept.log || fail "$(cat kept.log)"
! grep -q "6 of them" kept.log || fail "nothing of the killed job was kept"

run > second.log 2>&1 || fail "$(cat second.log)"
"$springcheck" sweep sweep.toml --out "my all.h5" --dry-run | grep -q "12 cases, 0 of them to compute" ||
  fail "cases are missing"
