#!/usr/bin/env bash
# Builds weft and runs every scene of samples/scenes; frames go to out/demo/NAME as OBJ files.
# usage: scripts/demo.sh [weft run options, for example --threads 1]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release >/dev/null
cmake --build build/release --parallel "${JOBS:-$(nproc)}" --target weft_cli

shopt -s nullglob
scenes=(samples/scenes/*.json)
if [[ ${#scenes[@]} -eq 0 ]]; then
  echo "demo: samples/scenes holds no scene (there is nothing to run)" >&2
  exit 1
fi
reports=()
for scene in "${scenes[@]}"; do
  out=out/demo/$(basename "$scene" .json)
  rm -rf "$out"
  mkdir -p "$out"
  build/release/tools/weft run "$scene" --out "$out" --format obj --every 0.1 \
    --report "$out/report.json" "$@"
  reports+=("$scene=$out/report.json")
done
python3 scripts/demo_table.py "${reports[@]}"
