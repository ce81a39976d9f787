"""Prints docs/effects.md. usage: effects_table.py ROWS.json (from `weft bench effects --json`)"""

import datetime
import json
import sys

from machine import processor

HEAD = """# What effects cost

*Made by `scripts/effects.sh`; do not edit. {date}, {processor}, one thread.*

A sheet of 256 x 256 particles (`seed12`, float32) in frames of 8 substeps at 0.9 of its stable
step. Each line is the same sheet with one thing more, timed turn by turn with the bare sheet;
figures are medians of {rounds} rounds, ratios are taken round by round. *Added* is per particle
and substep. Bytes are what the effect keeps on the device per particle; flops are the plan's
count for one substep, of the look alone where a collider is not touched.

The bare sheet: **{base:.2f} ns** per particle and substep, {bytes:.1f} bytes, {flops:.0f} flops
per particle. Its time is the {flops:.0f} flops, among them 12 roots and 12 divisions, and not the
memory: `weft bench grid` measures that floor in the same run.

| effect | added ns | ratio | bytes | flops | passes |
|---|---:|---:|---:|---:|---:|
"""
TAIL = """
## How to read it

- **An effect that a scene does not name costs nothing.** `hygiene.absent_effects` counts
  instructions against a build that does not even contain the optional stages: they differ by less
  than 1 %, the bytes not at all.
- **Out of reach** is what a scene pays for colliders that its cloth cannot touch in a frame: a
  look at whether the block of 32 particles has left the region for which that holds, while the
  new positions are still in registers. One look serves any number of colliders. `near but not
  touched` adds the list of each block, made once per frame.
- **Used** depends on how much of the sheet touches. `all of the sheet on it` is the worst case:
  every particle is pushed out in every substep. The spheres touch a part of the sheet only.
- **A mesh of triangles** costs what its contacts cost: the nearest triangle of a particle is
  exact, found in the list of its cell, and remembered as long as it cannot have changed. Its bytes
  are mostly the mesh itself, 33 MB here, whatever the number of particles.
- **Wind** computes each of the six triangles around a particle: six roots and seven divisions
  more.
- **A cape** is a damped sheet in wind, in frames of 32 substeps, beside the capsules of a body that
  a set moves every frame; it is compared with itself alone, and the calls that move the capsules
  count. A block turns a capsule once to look at it, and its particles only where it touches.
- **A sleeping cloth** still costs the survey at the end of a frame.
- **Normals** cost nothing until they are read; the figure is per particle of one call, with the
  copy into the caller's array.

`weft plan SCENE` prints the passes of a scene with their bytes and flops.
"""


with open(sys.argv[1], encoding="utf-8") as file:
    rows = json.load(file)["rows"]
value = {(r["case"], r["metric"]): r["median"] for r in rows}
bare = "bare sheet"
rounds = next(r["n"] for r in rows if r["metric"] == "ns_per_particle_step")
print(HEAD.format(date=datetime.date.today(), processor=processor(), rounds=rounds,
                  base=value[bare, "ns_per_particle_step"], bytes=value[bare, "bytes"],
                  flops=value[bare, "flops"]), end="")
for r in rows:
    if r["metric"] != "added":
        continue
    name = r["case"]
    cells = [f"{r['median']:+.2f}"]
    for metric, form in (("ratio", "{:.2f}"), ("bytes_added", "{:.1f}"), ("flops_added", "{:.0f}"),
                         ("passes_added", "{:.0f}")):
        cells.append(form.format(value[name, metric]) if (name, metric) in value else "-")
    print(f"| {name} | " + " | ".join(cells) + " |")
print(TAIL, end="")
