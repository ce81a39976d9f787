#!/usr/bin/env bash
# Makes the pictures of tests/render/golden anew. Look at them before they are committed.
# usage: scripts/golden_pictures.sh
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset release >/dev/null
cmake --build build/release --parallel "${JOBS:-$(nproc)}" --target weft_cli
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
rm -f tests/render/golden/*.png
for scene in samples/scenes/*.json; do
  name=$(basename "$scene" .json)
  [[ "$name" == fold ]] && continue  # takes minutes with a sanitizer
  LIBGL_ALWAYS_SOFTWARE=1 build/release/tools/weft run "$scene" --time 1 --every 1 \
    --format png --size 320x180 --out "$frames/$name" >/dev/null
  cp "$frames/$name/frame_000001.png" "tests/render/golden/$name.png"
done
echo "tests/render/golden has $(find tests/render/golden -name '*.png' | wc -l) pictures"
