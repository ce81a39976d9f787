#!/usr/bin/env bash
# Measures gather against scatter and writes docs/forces.md with its plots.
# usage: scripts/forces.sh [--quick]
# Builds the release preset first. Needs gnuplot (scripts/setup.sh --demo). Takes two minutes on a
# machine that does nothing else, half a minute with --quick.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --quick ) ]]; then
  echo "usage: scripts/forces.sh [--quick]" >&2
  exit 2
fi
if ! command -v gnuplot >/dev/null; then
  echo "forces: gnuplot is missing (it draws the plots) run scripts/setup.sh --demo" >&2
  exit 1
fi
cmake --preset release >/dev/null
cmake --build build/release --target weft_cli --parallel "${JOBS:-$(nproc)}" >/dev/null
export OMP_WAIT_POLICY=passive
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for table in forces grid accumulate; do
  build/release/tools/weft bench "$table" --json "$@" >"$work/$table.json"
done
python3 scripts/forces_page.py "$work" docs
echo "docs/forces.md and docs/pictures/forces_*.svg are made"
