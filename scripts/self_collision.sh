#!/usr/bin/env bash
# Measures what self-collision finds and costs, and writes docs/self-collision.md with its plots.
# usage: scripts/self_collision.sh [--quick]
# Builds the release preset first. Needs gnuplot (scripts/setup.sh --demo). Takes five minutes on a
# machine that does nothing else, half a minute with --quick, which leaves rows of its tables empty.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --quick ) ]]; then
  echo "usage: scripts/self_collision.sh [--quick]" >&2
  exit 2
fi
if ! command -v gnuplot >/dev/null; then
  echo "self_collision: gnuplot is missing (it draws the plots) run scripts/setup.sh --demo" >&2
  exit 1
fi
cmake --preset release >/dev/null
cmake --build build/release --target weft_cli --parallel "${JOBS:-$(nproc)}" >/dev/null
export OMP_WAIT_POLICY=passive
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/tools/weft bench collide --json "$@" >"$rows"
python3 scripts/self_collision_page.py "$rows" docs
echo "docs/self-collision.md and docs/pictures/self_collision_*.svg are made"
