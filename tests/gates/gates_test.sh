#!/usr/bin/env bash
# Runs a shipped sweep and judges it by the shipped gates of the same name.
#   gates_test.sh SPRINGCHECK NAME
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" sweep "$2" --out "$folder/results.h5"
"$1" gate "$2" "$folder/results.h5"
