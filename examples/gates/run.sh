#!/usr/bin/env bash
# What a pipeline runs after every change: computes the cases, judges them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

springcheck sweep cases.toml --out results.h5
springcheck gate gates.toml results.h5 --junit gates.xml
