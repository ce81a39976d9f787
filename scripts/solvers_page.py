"""Writes docs/solvers.md and its plots. usage: solvers_page.py ROWS.json DOCS

ROWS.json is what `weft bench stretch --json` printed; scripts/solvers.sh makes it. The words are
those of solvers_page.md.in. gnuplot draws the plots."""

import datetime
import os
import re
import sys

from machine import processor
from page import Rows, number, plot, table

SCENES = (("edge 128", 16384), ("edge 256", 65536), ("edge 512", 262144), ("pin 128", 16384),
          ("sphere 128", 16384), ("capes", 36000))


def percent(value):
    return "" if value is None else f"{value:.2f} %"


def signed(value, unit):
    return "" if value is None else f"{value:+.1f} {unit}"


def methods(rows, scene):
    found = [m[1] for m in rows.cases(re.escape(scene) + r": (.*)$", "frame")]
    return [m for m in found if not m.endswith("2 threads")]


def scene_table(rows, scene, particles):
    with_error = any(rows.get(f"{scene}: {m}", "kinetic_error") is not None
                     for m in methods(rows, scene))
    lines = []
    for method in methods(rows, scene):
        case = f"{scene}: {method}"
        get = lambda metric: rows.get(case, metric)
        frame, substeps = get("frame"), get("substeps")
        two = rows.get(f"{case}, 2 threads", "frame")
        line = [method, number(substeps), f"{frame:.2f}", "" if two is None else f"{two:.2f}",
                number(1e6 * frame / substeps / particles), percent(get("p99")),
                percent(get("largest")), percent(get("worst_p99")), percent(get("worst_largest"))]
        if with_error:
            line += [signed(get("height_error"), "mm"), signed(get("kinetic_error"), "%")]
        lines.append(line)
    head = ["method", "substeps", "ms a frame", "on two threads", "ns a particle and substep",
            "p99 at the end", "largest", "worst p99", "worst largest"]
    return table(head + (["height", "kinetic energy"] if with_error else []), lines)


def plots(rows, folder):
    for scene, _ in SCENES[:3]:
        curves = {}
        for method in methods(rows, scene):
            kind = re.sub(r"(xpbd|verlet) [\d.:]+( N/m)?", r"\1", method)
            case = f"{scene}: {method}"
            curves.setdefault(kind, []).append((rows.get(case, "frame"), rows.get(case, "p99")))
        name = f"solvers_{scene.replace(' ', '_')}.svg"
        plot(os.path.join(folder, name), f"Stretch against time, {scene} squared",
             ("ms a frame, one thread", "99th percentile of the stretch, %"),
             [(kind, sorted(points)) for kind, points in curves.items()],
             "set logscale xy\nset xtics (0.5, 1, 2, 3, 5, 10, 20, 50, 100, 200)")


def page(rows, words):
    made = {"measured": [f"Measured on {datetime.date.today().isoformat()}: {processor()}, "
                         "float32; a frame is the median of 70, CPU time of one thread, wall time "
                         "of two."]}
    for scene, particles in SCENES:
        made[scene.replace(" ", "_")] = scene_table(rows, scene, particles)
    for line in words:
        field = re.fullmatch(r"@(\w+)@", line)
        yield from made[field[1]] if field else [line]


def main():
    rows, docs = Rows(sys.argv[1]), sys.argv[2]
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "solvers_page.md.in"), encoding="utf-8") as file:
        words = file.read().splitlines()
    text = "\n".join(page(rows, words)) + "\n"
    with open(os.path.join(docs, "solvers.md"), "w", encoding="utf-8") as file:
        file.write(text)
    plots(rows, os.path.join(docs, "pictures"))


if __name__ == "__main__":
    main()
