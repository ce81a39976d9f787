"""Checks the number of compiled kernels. usage: variants.py PROJECT_ROOT

src/step/variants.h is the one table of them. Each kernel is compiled for three processor levels and
every GPU architecture, so effects are run-time branches and only types and stencils multiply.
"""

import re
import sys

import source_tree

MOST_KERNELS = 16
PRECISIONS = 2
TABLE = "src/step/variants.h"
# A row: `case KernelKind::tri6: return launch(GridSprings<T, Tri6>{...});`
ROW = re.compile(r"\bcase\s+KernelKind::(\w+)\s*:\s*return\s+launch\(\s*(\w+<[^>{]*>)\s*[{(]")


def check(root):
    text = source_tree.without_comments(source_tree.read(root, TABLE))
    rows = ROW.findall(text)
    problems = []
    if not rows or len(rows) != text.count("KernelKind::"):
        problems.append(f"{TABLE}: rows could not be read (each is `case KernelKind::NAME: "
                        "return launch(TYPE{...});`)")
    for column in zip(*rows):
        problems += [f"{TABLE}: {entry} is listed twice" for entry in sorted(set(column))
                     if column.count(entry) > 1]
    kernels = len(rows) * PRECISIONS
    if kernels > MOST_KERNELS:
        problems.append(f"{TABLE}: {kernels} kernels (at most {MOST_KERNELS}): "
                        "make the new choice a uniform branch between stages")
    return problems, f"{len(rows)} rows, {kernels} kernels"


if __name__ == "__main__":
    source_tree.report("variants", *check(sys.argv[1]))
