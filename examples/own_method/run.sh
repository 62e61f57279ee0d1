#!/usr/bin/env bash
# Computes a scene with mine.py, measures what it found, and judges it beside others.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

springcheck mesh uniaxial --out cube.inp
/usr/bin/python3 mine.py
springcheck measure uniaxial --deformation -10% --reference fem-hencky \
  --displacements mine.csv --forces forces.csv --label mine --out results.h5
springcheck run uniaxial --deformation -10% --reference fem-hencky --method mss-cf,fem-hencky \
  --out results.h5
springcheck gate mine.toml results.h5
