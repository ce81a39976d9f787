"""Writes docs/self-collision.md and its plots. usage: self_collision_page.py ROWS.json DOCS

ROWS.json is what `weft bench collide --json` printed; scripts/self_collision.sh makes it. The words
are those of self_collision_page.md.in. gnuplot draws the plots."""

import datetime
import os
import re
import sys

from machine import processor
from page import Rows, number, plot, table

GRIDS = ("1 corner", "2 corner", "4 corner", "8 corner", "4 diagonal")
CELLS = ("1", "2", "4")
WINDOWS = ("none", "16", "8", "4", "2", "1")
UNIFORM, CRUMPLED = "uniform", "crumpled, r = spacing"
CROWDS = ("uniform, a quarter of the points", UNIFORM, "uniform, four times the points",
          "crumpled, r = spacing/2", CRUMPLED, "crumpled, r = 2 spacing")


def case(of, grids, cells, window="none"):
    tail = "no window" if window == "none" else f"window {window}"
    return f"{of}: staggered, {grids}, h = {cells} r, {tail}"


def whole(value):
    return "" if value is None else f"{value:,.0f}".replace(",", " ")


def share(value):
    return "" if value is None else f"{value:.4f}"


def percent(value):
    return "" if value is None else f"{100 * value:.1f} %"


def formula(rows):
    lines = []
    for grids in GRIDS:
        cells = []
        for h in CELLS:
            name = case(UNIFORM, grids, h)
            cells += [share(rows.get(name, metric))
                      for metric in ("predicted_recall", "mean_recall")]
        lines.append([grids] + cells)
    return table(["grids"] + [f"h = {h} r: {what}" for h in CELLS
                              for what in ("formula", "measured")], lines)


def windows(rows, of):
    lines = []
    for h in CELLS:
        for grids in GRIDS:
            lines.append([f"h = {h} r, {grids}"] +
                         [share(rows.get(case(of, grids, h, w), "mean_recall")) for w in WINDOWS])
    return table(["recall by window"] + list(WINDOWS), lines)


def crowds(rows):
    lines = []
    for of in CROWDS:
        found = [case(of, "8 corner", "2", w) for w in ("none", "8", "4")]
        lines.append([of, number(rows.get(of, "near_points")),
                      number(rows.get(f"{of}: h = 2 r", "points_per_cell"))] +
                     [share(rows.get(name, "mean_recall")) for name in found] +
                     [whole(rows.get(found[0], "substep")),
                      whole(rows.get(f"{of}: complete", "substep"))])
    return table(["8 corner grids, h = 2 r", "near a point", "in its cell", "no window", "window 8",
                  "window 4", "ns, no window", "ns, complete"], lines)


def costs(rows):
    lines = [["complete"] + [cell for of in (UNIFORM, CRUMPLED) for cell in
                             (share(rows.get(f"{of}: complete", "mean_recall")),
                              whole(rows.get(f"{of}: complete", "substep")))]]
    for h in CELLS:
        for grids in GRIDS:
            cells = []
            for of in (UNIFORM, CRUMPLED):
                name = case(of, grids, h)
                cells += [share(rows.get(name, "mean_recall")), whole(rows.get(name, "substep"))]
            lines.append([f"h = {h} r, {grids}"] + cells)
    return table(["no window", "uniform: recall", "ns per particle", "crumpled: recall",
                  "ns per particle"], lines)


def runs(rows):
    """(substeps, way) of the runs, in the order of their rows."""
    return [(int(m[1]), m[2]) for m in rows.cases(r"folding, (\d+) substeps: (.*)$", "crossings")]


def steps(rows):
    lines = []
    for substeps, way in runs(rows):
        name = f"folding, {substeps} substeps: {way}"
        lines.append([f"{substeps}, {way}", number(rows.get(name, "substeps_per_encounter"))] +
                     [percent(rows.get(name, metric)) for metric in
                      ("encounters_missed", "encounters_between_substeps", "nearer_than_half")] +
                     [number(rows.get(name, "least_distance")), whole(rows.get(name, "crossings")),
                      number(rows.get(name, "cost"))])
    return table(["substeps of a frame, search", "substeps of an encounter", "encounters missed",
                  "passed between substeps", "nearer than r/2", "least distance, r", "crossings",
                  "time / none"], lines)


def plots(rows, folder):
    series = []
    for of in (UNIFORM, CRUMPLED):
        for window in ("none", "4"):
            points = []
            for grids in GRIDS[:4]:
                name = case(of, grids, "2", window)
                if rows.get(name, "substep") is not None:
                    points.append((rows.get(name, "substep"), rows.get(name, "mean_recall")))
            tail = "no window" if window == "none" else f"window {window}"
            series.append((f"{of.split(',')[0]}, {tail}", sorted(points)))
        series.append((f"{of.split(',')[0]}, complete",
                       [(rows.get(f"{of}: complete", "substep"), 1)]))
    plot(os.path.join(folder, "self_collision_cost.svg"),
         "1, 2, 4 and 8 corner grids, h = 2 r",
         ("ns per particle and substep", "recall"), series, "set logscale x; set yrange [0:1.05]")
    series = []
    for of in (UNIFORM, CRUMPLED):
        for h in CELLS:
            points = [(w, rows.get(case(of, "8 corner", h, w), "mean_recall"))
                      for w in reversed(WINDOWS)]
            if any(p[1] is not None for p in points):
                series.append((f"{of.split(',')[0]}, h = {h} r", points))
    plot(os.path.join(folder, "self_collision_window.svg"), "8 corner grids",
         ("window", "recall"), series, "set yrange [0:1.05]; set xtics")
    series = {}
    for substeps, way in runs(rows):
        missed = rows.get(f"folding, {substeps} substeps: {way}", "encounters_missed")
        if missed is not None:
            series.setdefault(way, []).append((substeps, 100 * missed))
    plot(os.path.join(folder, "self_collision_steps.svg"), "A sheet that folds onto itself",
         ("substeps of a frame", "encounters never seen, %"), list(series.items()),
         "set logscale x 2")


def main(path, docs):
    rows = Rows(path)
    plots(rows, os.path.join(docs, "pictures"))
    measured = (f"*Measured on {datetime.date.today().isoformat()}, {processor()}, one thread, by "
                "`scripts/self_collision.sh`; compare ratios, machines differ.*")
    template = os.path.join(os.path.dirname(os.path.abspath(__file__)), "self_collision_page.md.in")
    with open(template, encoding="utf-8") as file:
        page = file.read()
    tables = {"formula": formula(rows), "costs": costs(rows), "crowds": crowds(rows),
              "windows_uniform": windows(rows, UNIFORM),
              "windows_crumpled": windows(rows, CRUMPLED), "steps": steps(rows)}
    values = {"measured": measured, "pairs": f"{rows.get(UNIFORM, 'pairs'):,.0f}"}
    values.update({name: "\n".join(lines).rstrip() for name, lines in tables.items()})
    page = re.sub(r"@(\w+)@", lambda m: values[m[1]], page)
    with open(os.path.join(docs, "self-collision.md"), "w", encoding="utf-8") as file:
        file.write(page)


main(*sys.argv[1:])
