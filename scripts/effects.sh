#!/usr/bin/env bash
# Measures what each effect costs and writes docs/effects.md.
# usage: scripts/effects.sh [--quick]
# Builds the release preset first. Takes about a minute on a machine that does nothing else.
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --quick ) ]]; then
  echo "usage: scripts/effects.sh [--quick]" >&2
  exit 2
fi
export OMP_WAIT_POLICY=passive
cmake --preset release >/dev/null
cmake --build --preset release --target weft_cli -- -j"$(nproc)" >/dev/null
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/tools/weft bench effects --json "$@" >"$rows"
python3 scripts/effects_table.py "$rows" >docs/effects.md
echo "docs/effects.md is made"
