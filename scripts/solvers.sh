#!/usr/bin/env bash
# Measures what keeps cloth from stretching costs, and writes docs/solvers.md with its plots.
# usage: scripts/solvers.sh [--quick]
# Builds the release preset first. Needs gnuplot (scripts/setup.sh --demo). Takes two minutes on a
# machine that does nothing else, half a minute with --quick, which leaves rows of its tables empty.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --quick ) ]]; then
  echo "usage: scripts/solvers.sh [--quick]" >&2
  exit 2
fi
if ! command -v gnuplot >/dev/null; then
  echo "solvers: gnuplot is missing (it draws the plots) run scripts/setup.sh --demo" >&2
  exit 1
fi
cmake --preset release >/dev/null
cmake --build build/release --target weft_cli --parallel "${JOBS:-$(nproc)}" >/dev/null
export OMP_WAIT_POLICY=passive
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/tools/weft bench stretch --json "$@" >"$rows"
python3 scripts/solvers_page.py "$rows" docs
echo "docs/solvers.md and docs/pictures/solvers_*.svg are made"
