#!/usr/bin/env bash
# Measures one table of `weft bench` and writes the page of docs that is made of it, with its plots.
# usage: scripts/bench_page.sh TABLE NAME PAGE [--quick]
# scripts/NAME_page.py writes docs/PAGE.md and docs/pictures/NAME_*.svg. Builds the release preset
# first. Needs gnuplot (scripts/setup.sh --demo). --quick leaves rows of the tables empty.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -lt 3 || $# -gt 4 || ( $# -eq 4 && "$4" != --quick ) ]]; then
  echo "usage: scripts/bench_page.sh TABLE NAME PAGE [--quick]" >&2
  exit 2
fi
table=$1 name=$2 page=$3
if ! command -v gnuplot >/dev/null; then
  echo "$name: gnuplot is missing (it draws the plots) run scripts/setup.sh --demo" >&2
  exit 1
fi
cmake --preset release >/dev/null
cmake --build build/release --target weft_cli --parallel "${JOBS:-$(nproc)}" >/dev/null
export OMP_WAIT_POLICY=passive
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/tools/weft bench "$table" --json "${@:4}" >"$rows"
python3 "scripts/${name}_page.py" "$rows" docs
echo "docs/$page.md and docs/pictures/${name}_*.svg are made"
