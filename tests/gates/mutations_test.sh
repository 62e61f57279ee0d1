#!/usr/bin/env bash
# Breaks one formula at a time in a copy of the sources, builds, and expects that the gates of
# accuracy.toml, as they are, notice.
#   mutations_test.sh SOURCES
set -euo pipefail
sources=$1
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git -C "$sources" ls-files -z | (cd "$sources" && xargs -0 cp --parents -t "$copy")
cd "$copy"
cmake --preset release -Wno-dev --log-level=WARNING >/dev/null
build() { cmake --build --preset release -- -j "$(nproc)" springcheck >build.log 2>&1 || { cat build.log; exit 1; }; }
gates() {  # exit status of the gates on this build's cases
  rm -f results.h5
  build/release/springcheck sweep accuracy --out results.h5 >sweep.log 2>&1 || return $?
  unbroken/springcheck gate accuracy results.h5 >gates.log 2>&1
}
build
mkdir unbroken
cp build/release/springcheck build/release/springcheck-core unbroken/
gates || { cat gates.log; echo "the gates fall short without a mutation" >&2; exit 1; }

failed=0
mutate() {  # name, file, sed expression
  cp "$2" original
  sed -i "$3" "$2"
  cmp -s "$2" original && { echo "$1: the expression matches nothing in $2" >&2; exit 1; }
  build
  cp original "$2"
  status=0
  gates || status=$?
  echo "$1: exit status $status, $(grep -c 'falls short' gates.log || true) lines fall short"
  [ "$status" -eq 1 ] || failed=1
}
mutate "sign of kappa" mss/networks/stiffness.cpp 's/return E \* (4 \* nu - 1)/return E * (1 - 4 * nu)/'
mutate "share of face diagonals" mss/networks/network.cpp 's/k.face_diagonal \/ 2/k.face_diagonal \/ 4/'
mutate "a term of the volume's gradient" mss/networks/deformation.cpp \
  's/F.col(2).cross(F.col(0))/F.col(0).cross(F.col(2))/'
mutate "sum over the plate" comparisons/measures/measures.cpp \
  's/  for (const NodeIndex node : nodes) {/  for (const NodeIndex node : std::span(nodes).subspan(1)) {/'
mutate "split of selective reduced integration" fem_reference/cells/cell.cpp \
  's/if (settings.element != Element::q1_sri) return/if (settings.law != Law::cauchy_born) return/'
mutate "share of the mass" mss/networks/network.cpp 's/density \* shares/density * 2 * shares/'
exit $failed
