"""Writes docs/forces.md and its plots. usage: forces_page.py FOLDER DOCS

FOLDER holds forces.json, grid.json and accumulate.json, as `weft bench NAME --json` prints them;
scripts/forces.sh makes them. The words are those of forces_page.md.in. gnuplot draws the plots."""

import datetime
import os
import re
import sys

from machine import processor
from page import Rows, number, plot, table

# Georgii and Westermann 2005, Table 2: ms on an ATI X800 XT.
PUBLISHED = {128: {"PCA": (0.54, None, 0.20, 0.74), "ECA": (0.40, 0.12, 0.20, 0.72)},
             256: {"PCA": (2.34, None, 0.74, 3.08), "ECA": (1.76, 0.52, 0.74, 3.02)},
             512: {"PCA": (9.82, None, 3.18, 13.0), "ECA": (7.34, 2.08, 3.18, 12.6)}}
WAYS = {"gather": "PCA", "scatter native": "ECA"}
PARTS = ("force_calculation", "force_accumulation", "integration", "total")
STATES = ("noise of 10 % h", "noise of 1 % h", "equilibrium + 1e-4 h", "equilibrium")
NS = "ns_per_edge"
LAYOUT = "256x256 regular, sliced rows"


class Forces(Rows):
    def sizes(self):
        return [int(m[1]) for m in self.cases(r"(\d+)x\d+ tri6 mesh, gather$", "total")]


def table_1(rows):
    lines = []
    for n in rows.sizes():
        for way, name in WAYS.items():
            case = f"{n}x{n} tri6 mesh, {way}"
            lines.append([f"{n} x {n}, {way} ({name})"] +
                         [f"{rows.get(case, m):,.0f}".replace(",", " ")
                          for m in ("memory", "reads", "dependent_reads", "operations")])
    return table(["", "bytes", "reads", "dependent reads", "operations"], lines)


def table_2(rows):
    lines = []
    for n in rows.sizes():
        for way, name in WAYS.items():
            case = f"{n}x{n} tri6 mesh, {way}"
            lines.append([f"{n} x {n}, {way}"] + [number(rows.get(case, p)) for p in PARTS] +
                         [number(rows.get(case, NS))])
            if n in PUBLISHED:
                lines.append([f"*{name} 2005*"] +
                             [number(v) for v in PUBLISHED[n][name]] + [""])
        lines.append([f"{n} x {n} as a grid, gather", "", "", "", "",
                      number(rows.get(f"{n}x{n} tri6, grid gather", NS))])
    return table(["ms a substep", "forces", "accumulation", "integration", "total",
                  "ns per edge"], lines)


def megabytes(rows, case):
    return number(1e-6 * rows.get(case, "bytes"))


def meshes(rows):
    lines = []
    for match in rows.cases(r"(.*) (float32|float64), gather$", NS):
        name, precision = match[1], match[2]
        gather = rows.get(f"{name} {precision}, gather", NS)
        scatter = rows.get(f"{name} {precision}, scatter native", NS)
        choice = [m for m in rows.cases(re.escape(f"{name} {precision}") +
                                        r", automatic (\w+) / best$", "ratio")]
        ratio = rows.get(choice[0][0], "ratio") if choice else None
        lines.append([f"{name}, {precision}", number(gather), number(scatter),
                      number(scatter / gather), choice[0][1] if choice else "", number(ratio),
                      megabytes(rows, f"{name} {precision}, gather"),
                      number(rows.get(f"{name} {precision}, gather", "floor_share"), 2),
                      number(rows.get(f"{name} {precision}, scatter native", "floor_share"), 2)])
    return table(["ns per edge", "gather", "scatter native", "scatter / gather", "`auto` takes",
                  "its time / best", "MB, gather", "floor / gather", "floor / scatter"], lines)


def layouts(rows):
    names = ["256x256 tri6, grid gather, again", "256x256 tri6, grid, every spring once"]
    for kind in ("regular", "irregular"):
        names += [f"256x256 {kind}, {rows_of}" for rows_of in
                  ("sliced rows", "compressed rows", "padded rows")]
    names += [m[0] for m in rows.cases(r"256x256 regular, scatter \w+$", NS)]
    names.append("floor: a root and a division")
    floor = rows.get(names[-1], NS)
    lines = [[name.replace(", again", ""), number(rows.get(name, NS)),
              number(floor * (1 if "scatter" in name or "once" in name or "floor" in name else 2) /
                     rows.get(name, NS), 2)] for name in names]
    return table(["float32, one thread", "ns per edge", "floor / time"], lines)


def errors(rows):
    modes = []
    for match in rows.cases(r"equilibrium: (.*)$", "equilibrium_error"):
        modes.append(match[1])
    lines = []
    for mode in modes:
        cells = [number(rows.get(f"{s}: {mode}", "force_error"), 2) for s in STATES[:3]]
        lines.append([mode] + cells +
                     [number(rows.get(f"equilibrium: {mode}", "equilibrium_error"), 2)])
    return table(["precision, sum"] + [f"force, {s}" for s in STATES[:3]] +
                 ["equilibrium, m"], lines)


def figure(rows):
    lines = []
    for match in rows.cases(r"(\d+)x\d+ weft float32, 1 thread, by size$",
                            "ns_per_particle_step"):
        n = int(match[1])
        values = [rows.get(f"{n}x{n} {name}, by size", "ns_per_particle_step")
                  for name in ("chapter loop, -O3", "chapter loop, bit-safe flags",
                               "weft float32, 1 thread")]
        lines.append([f"{n} x {n}"] + [number(v) for v in values] +
                     [number(values[0] / values[2]) if values[0] else "",
                      number(1e-6 * values[2] * n * n)])
    return table(["ns per particle and substep", "the chapter's loop, -O3", "with bit-safe flags",
                  "weft", "times faster than -O3", "weft, ms a substep"], lines)


def page_of(measured, forces, sums, tables):
    """The page; `tables` are lines by name."""
    def force(case, metric=NS):
        return forces.get(case, metric)

    def error(case, metric="force_error"):
        return sums.get(case, metric)

    gather, scatter = "256x256 tri6 mesh, gather", "256x256 tri6 mesh, scatter native"
    values = {
        "measured": measured,
        "operations": force(scatter, "operations") / force(gather, "operations"),
        "memory": force(scatter, "memory") / force(gather, "memory"),
        "irregular": force("256x256 irregular float32 / regular, gather", "ratio"),
        "padded": force("irregular: padded / sliced rows", "ratio"),
        "whole_grid": 100 * force("two floors / 256x256 tri6, grid gather", "ratio"),
        "whole_mesh": 100 * force("two floors / 256x256 regular, sliced rows", "ratio"),
        "share_mesh": 100 * force("256x256 tri6, floor / force calculation, mesh gather", "ratio"),
        "threads": force("network of valence 20 and 4, 1 thread / 2 threads", "ratio"),
        "gather": force(gather, "total"), "scatter": force(scatter, "total"),
        "fixed64": force("256x256 regular, scatter fixed64"),
        "atomic": force("256x256 regular, scatter atomic"),
        "atomics": force("256x256 regular, scatter fixed64") / force(LAYOUT),
        "fixed8": error("noise of 10 % h: float32, fixed8"),
        "fixed8_wide": error("noise of 10 % h: float32, fixed8, full scale 4 forces"),
        "float16": error("noise of 10 % h: float32, float16"),
        "cancelled": error("equilibrium + 1e-4 h: float32, gather"),
        "equilibrium8": error("equilibrium: float32, fixed8", "equilibrium_error"),
        "equilibrium16": error("equilibrium: float32, float16", "equilibrium_error"),
    }
    values.update({name: "\n".join(lines) for name, lines in tables.items()})
    template = os.path.join(os.path.dirname(os.path.abspath(__file__)), "forces_page.md.in")
    with open(template, encoding="utf-8") as file:
        return file.read().format(**values)


def plots(forces, grid, sums, folder):
    sizes = forces.sizes()
    series = [(f"weft, {way}", [(n, forces.get(f"{n}x{n} tri6 mesh, {way}", "total"))
                                for n in sizes]) for way in WAYS]
    series += [(f"{name}, 2005", [(n, PUBLISHED[n][name][3]) for n in PUBLISHED])
               for name in WAYS.values()]
    plot(os.path.join(folder, "forces_time.svg"), "A substep of the valence-6 mesh",
         ("vertices along a side", "ms"), series, "set logscale xy 2")
    series = []
    for name in ("chapter loop, -O3", "chapter loop, bit-safe flags", "weft float32, 1 thread"):
        points = []
        for match in grid.cases(r"(\d+)x\d+ " + re.escape(name) + ", by size$",
                                "ns_per_particle_step"):
            n = int(match[1])
            points.append((n, 1e-6 * n * n * grid.get(match[0], "ns_per_particle_step")))
        series.append((name, points))
    plot(os.path.join(folder, "forces_sizes.svg"), "A substep of the 12-neighbour grid",
         ("vertices along a side", "ms"), series, "set logscale xy 2")
    modes = [m[1] for m in sums.cases(r"equilibrium: (float32, .*)$", "equilibrium_error")]
    series = [(state, [(f'"{mode.replace("float32, ", "").replace(", full scale", "")}"',
                        sums.get(f"{state}: {mode}", "force_error")) for mode in modes])
              for state in STATES[:3]]
    plot(os.path.join(folder, "forces_errors.svg"), "Error of forces by how they are added up",
         ("", "relative error"), series,
         'set logscale y; set format y "%.0e"; set xtics rotate by -35')


def main(folder, docs):
    forces = Forces(os.path.join(folder, "forces.json"))
    grid, sums = (Rows(os.path.join(folder, f"{name}.json")) for name in ("grid", "accumulate"))
    plots(forces, grid, sums, os.path.join(docs, "pictures"))
    measured = (f"*Measured on {datetime.date.today().isoformat()}, {processor()}, one thread, by "
                "`scripts/forces.sh`; compare ratios, machines differ.*")
    page = page_of(measured, forces, sums, {
        "table_1": table_1(forces), "table_2": table_2(forces), "meshes": meshes(forces),
        "layouts": layouts(forces), "figure": figure(grid), "errors": errors(sums)})
    with open(os.path.join(docs, "forces.md"), "w", encoding="utf-8") as file:
        file.write(page)


main(*sys.argv[1:])
