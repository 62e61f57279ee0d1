#!/usr/bin/env bash
# What `cmake --install` puts in place works without the clone: the program, the Python
# module, the libraries in a program of one's own, the examples.
# Usage: install_test.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install "$build" --prefix "$folder/usr" >/dev/null
export PATH="$folder/usr/bin:$PATH"
export PYTHONPATH="$folder/usr/lib/python3/dist-packages"
cp -r "$folder/usr/share/doc/springcheck/examples" "$folder/examples"
cd "$folder"

[ "$(command -v springcheck)" = "$folder/usr/bin/springcheck" ]
springcheck help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' > commands.txt
for command in $(cat commands.txt); do
  MANPATH="$folder/usr/share/man" man "springcheck-$command" | grep -q "^SYNOPSIS"
done
[ "$(wc -l < commands.txt)" -ge 18 ]
MANPATH="$folder/usr/share/man" man --warnings springcheck 2>&1 >/dev/null | (! grep .)
bash -c "source usr/share/bash-completion/completions/springcheck; complete -p springcheck"
[ -s usr/share/fish/vendor_completions.d/springcheck.fish ]
[ -s usr/share/zsh/vendor-completions/_springcheck ]
bash examples/own_method/run.sh
bash examples/gates/run.sh
springcheck report examples/gates/results.h5 --out page
grep -q "springs press like finite elements" examples/gates/gates.xml
/usr/bin/python3 -c "
import springcheck_results
cases = springcheck_results.read('examples/gates/results.h5').cases
assert len(cases) == 4, cases"

cmake -S examples/own_spring -B own -DCMAKE_PREFIX_PATH="$folder/usr" >/dev/null
cmake --build own
own/own_spring | tee own.txt
# mss-custom, with the same constants: 19/144 E h = 8.2465 N/m in cells of 6.25 mm.
springcheck run compression --cells 8,8,8 --method mss-custom,fem-hencky \
  --stiffness 32.986111111111114,16.493055555555557,8.246527777777779 --json > run.json
/usr/bin/python3 - <<'PYTHON'
import json
import re

forces = [float(number) for number in re.findall(r"[\d.]+(?= N)", open("own.txt").read())]
results = json.load(open("run.json"))["results"]
expected = [abs(result["force"][2]) for result in results]
# own_spring prints four decimals.
assert all(abs(a - b) < 6e-5 for a, b in zip(forces, expected, strict=True)), (forces, expected)
PYTHON
