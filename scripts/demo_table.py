"""Prints what runs cost. usage: demo_table.py SCENE.json=REPORT.json..."""

import json
import os
import sys

HEAD = ("scene", "particles", "springs", "substeps", "ms/frame", "times real time")


def row(scene_path, report_path):
    with open(scene_path, encoding="utf-8") as file:
        frame = json.load(file).get("time", {}).get("frame", 1 / 60)
    with open(report_path, encoding="utf-8") as file:
        report = json.load(file)
    seconds = report["wall_seconds"] / report["frames"]
    name = os.path.splitext(os.path.basename(scene_path))[0]
    return (name, str(report["particles"]), str(report["springs"]),
            str(report["substeps_per_frame"]), f"{seconds * 1e3:.2f}", f"{frame / seconds:.1f}")


rows = [HEAD] + [row(*pair.split("=")) for pair in sys.argv[1:]]
widths = [max(map(len, column)) for column in zip(*rows)]
print()
for cells in rows:
    figures = [cell.rjust(width) for cell, width in zip(cells[1:], widths[1:])]
    print("  ".join([cells[0].ljust(widths[0]), *figures]))
print("\nTime is spent in steps only (reading, writing and cooking excluded).")
