#!/usr/bin/env bash
# Builds weft, runs every scene of samples/scenes, those with self-collision without it too, and
# makes out/demo/contact_sheet.png (four moments of each), out/demo/demo.mp4 (one after the other)
# and a table of what they cost.
# usage: scripts/demo.sh [weft run options, for example --threads 1]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh --demo
cmake --preset release >/dev/null
cmake --build build/release --parallel "${JOBS:-$(nproc)}" --target weft_cli

shopt -s nullglob
scenes=(samples/scenes/*.json)
if [[ ${#scenes[@]} -eq 0 ]]; then
  echo "demo: samples/scenes holds no scene (there is nothing to run)" >&2
  exit 1
fi
rm -rf out/demo
mkdir -p out/demo
python3 scripts/demo_scenes.py out/demo "${scenes[@]}" >out/demo/scenes.txt
mapfile -t scenes <out/demo/scenes.txt
formats=png,mp4
command -v ffmpeg >/dev/null || formats=png

reports=()
for scene in "${scenes[@]}"; do
  name=$(basename "$scene" .json)
  echo "demo: $name"
  build/release/tools/weft run "$scene" --out "out/demo/$name" --format "$formats" \
    --every 0.033333333333333333 --report "out/demo/$name/report.json" "$@" >/dev/null
  reports+=("$scene=out/demo/$name/report.json")
done

# Four moments of a scene as one row: the start, a third, two thirds, the end.
row_of() {  # NAME
  local frames=("out/demo/$1"/frame_*.png) inputs=() part
  for part in 0 1 2 3; do
    inputs+=(-i "${frames[$(((${#frames[@]} - 1) * part / 3))]}")
  done
  ffmpeg -nostdin -loglevel error -y "${inputs[@]}" \
    -filter_complex "hstack=inputs=4,scale=1280:-1" -update 1 -frames:v 1 "out/demo/$1/row.png"
}

if [[ "$formats" == png ]]; then
  echo "demo: ffmpeg is missing (the contact sheet and the film need it); pictures: out/demo"
else
  rows=()
  for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .json)
    row_of "$name"
    rows+=(-i "out/demo/$name/row.png")
    echo "file '$name/$name.mp4'"
  done >out/demo/films.txt
  ffmpeg -nostdin -loglevel error -y "${rows[@]}" -filter_complex "vstack=inputs=${#scenes[@]}" \
    -update 1 -frames:v 1 out/demo/contact_sheet.png
  ffmpeg -nostdin -loglevel error -y -f concat -i out/demo/films.txt -c copy out/demo/demo.mp4
fi
python3 scripts/demo_table.py "${reports[@]}"
if [[ "$formats" != png ]]; then
  echo "contact sheet: out/demo/contact_sheet.png"
  echo "film:          out/demo/demo.mp4"
fi
