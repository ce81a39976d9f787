"""Writes the figures of README.md. usage: figures_table.py WEFT ROWS.json README.md

ROWS.json is what `weft bench grid --json` printed. How exact a run is, is measured here: a sheet
falls from its pins with ever more substeps in both precisions, and is compared with float64 at 64
times the substeps that are stable."""

import csv
import datetime
import json
import math
import os
import subprocess
import sys
import tempfile

from machine import processor

BEGIN, END = "<!-- figures: scripts/figures.sh -->", "<!-- end of figures -->"
SECONDS = 0.25
SCENE = {
    "weft": 1,
    "cloths": [{
        "name": "sheet",
        "grid": {"rows": 64, "columns": 64, "width": 1.0, "height": 1.0, "stencil": "tri6"},
        "transform": {"rotate": {"axis": [1, 0, 0], "degrees": 90}},
        "mass": 0.2, "stiffness": {"stretch": 200, "shear": 100},
        "damping": {"drag": 1e-4, "spring": 1e-3},
        "pins": [{"corners": True}]}],
}


def positions(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [tuple(float(row[k]) for k in "xyz") for row in csv.DictReader(file)]


def simulate(weft, folder, precision, substeps):
    """Positions at the end, and the report; substeps None is what weft chooses."""
    scene = dict(SCENE, solver={"precision": precision})
    scene["time"] = {"duration": SECONDS, "substeps": substeps or "auto"}
    paths = [os.path.join(folder, name) for name in ("scene.json", "final.csv", "report.json")]
    with open(paths[0], "w", encoding="utf-8") as file:
        json.dump(scene, file)
    subprocess.run([weft, "run", paths[0], "--threads", "1", "--final", paths[1],
                    "--report", paths[2]], check=True, stdout=subprocess.DEVNULL)
    with open(paths[2], encoding="utf-8") as file:
        return positions(paths[1]), json.load(file)


def rms_mm(a, b):
    square = sum(math.dist(p, q) ** 2 for p, q in zip(a, b))
    return 1e3 * math.sqrt(square / len(a))


def exactness(weft):
    yield ("| substeps a frame | of the bound | float32: error | ms a frame "
           "| float64: error | ms a frame |")
    yield "|---:|---:|---:|---:|---:|---:|"
    with tempfile.TemporaryDirectory() as folder:
        _, chosen = simulate(weft, folder, "float64", None)
        least = chosen["substeps_per_frame"]
        truth, _ = simulate(weft, folder, "float64", 64 * least)
        for factor in (1, 2, 4, 8, 16):
            cells = []
            for precision in ("float32", "float64"):
                runs = [simulate(weft, folder, precision, factor * least) for _ in range(5)]
                seconds = sorted(r["wall_seconds"] / r["frames"] for _, r in runs)[2]
                cells += [f"{rms_mm(runs[0][0], truth):.2g} mm", f"{1e3 * seconds:.2f}"]
            bound = runs[0][1]["dt"] / runs[0][1]["dt_bound"]
            yield f"| {factor * least} | {bound:.2f} | " + " | ".join(cells) + " |"


def cost(rows):
    of = {(row["case"], row["metric"]): row for row in rows}

    def value(case, metric="ns_per_particle_step"):
        return of[case, metric]["median"]

    yield "| a sheet of 256 x 256, 12 springs a particle | ns per particle and substep |"
    yield "|---|---:|"
    yield f"| the textbook loop, `-O3` | {value('256x256 chapter loop, -O3'):.1f} |"
    yield f"| weft, float32, one thread | {value('256x256 weft float32, 1 thread'):.2f} |"
    yield f"| weft, float32, two threads | {value('256x256 weft float32, 2 threads'):.2f} |"
    yield f"| weft, float64, one thread | {value('256x256 weft float64, 1 thread'):.2f} |"
    yield ("| floor: the 12 roots and divisions alone, float32 | "
           f"{value('12 roots and divisions, float32'):.2f} |")


def block(weft, rows):
    yield BEGIN
    yield (f"*Measured on {datetime.date.today().isoformat()}, {processor()}, by "
           "`scripts/figures.sh`; compare ratios, machines differ.*")
    yield ""
    yield from cost(rows)
    yield ""
    yield (f"And what accuracy costs: a pinned sheet of 64 x 64 after {SECONDS} s, root mean "
           "square distance of its")
    yield "particles from a float64 run with 64 times the substeps, and the time of one thread:"
    yield ""
    yield from exactness(weft)
    yield END


def main(weft, rows, readme):
    with open(rows, encoding="utf-8") as file:
        made = "\n".join(block(weft, json.load(file)["rows"]))
    with open(readme, encoding="utf-8") as file:
        text = file.read()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit(f"{readme} lacks its marks (the figures go between them) "
                 f"put back {BEGIN} and {END}")
    before, rest = text.split(BEGIN)
    with open(readme, "w", encoding="utf-8") as file:
        file.write(before + made + rest.split(END)[1])


main(*sys.argv[1:])
