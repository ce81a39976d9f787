"""Prints a table of what scenes cost. usage: demo_table.py SCENE=REPORT.json..."""

import json
import os
import sys

COLUMNS = ["scene", "particles", "springs", "substeps", "ms/frame", "x real time", "stretch",
           "dt/bound"]


def row(scene, report):
    frames = max(report["frames"], 1)
    seconds = report["wall_seconds"] / frames
    shown = report["dt"] * report["substeps_per_frame"]
    bound = report["dt_bound"]
    return [os.path.splitext(os.path.basename(scene))[0],
            str(report["particles"]), str(report["springs"]), str(report["substeps_per_frame"]),
            f"{seconds * 1e3:.2f}", f"{shown / seconds:.1f}" if seconds > 0 else "-",
            f"{100 * report['largest_stretch']:.0f} %",
            f"{report['dt'] / bound:.2f}" if bound else "-"]


def main(arguments):
    rows = [COLUMNS]
    for argument in arguments:
        scene, _, path = argument.partition("=")
        with open(path, encoding="utf-8") as file:
            rows.append(row(scene, json.load(file)))
    widths = [max(len(line[i]) for line in rows) for i in range(len(COLUMNS))]
    for line in rows:
        cells = [line[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(line[1:], widths[1:])]
        print("  ".join(cells))
    print("\nTime is spent in steps only (reading, drawing, writing and cooking excluded).")


main(sys.argv[1:])
