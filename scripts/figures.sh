#!/usr/bin/env bash
# Measures the figures of README.md and writes them between its marks, and docs/effects.md.
# usage: scripts/figures.sh [--quick]
# Builds the release preset first. Takes about three minutes on a machine that does nothing else.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --quick ) ]]; then
  echo "usage: scripts/figures.sh [--quick]" >&2
  exit 2
fi
scripts/effects.sh "$@"
export OMP_WAIT_POLICY=passive
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/tools/weft bench grid --json "$@" >"$rows"
python3 scripts/figures_table.py build/release/tools/weft "$rows" README.md
echo "the figures of README.md are made"
