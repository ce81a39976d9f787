"""Counts packed and scalar square roots in the kernels' object code.

usage: vectorised.py OBJDUMP NAMESPACE ALLOW_LIST OBJECT...

A kernel that g++ stopped vectorising still gives the same bits, several times slower, without a
word. Square roots tell: they cannot hide in address arithmetic, and every spring has one. Functions
with square roots must have packed ones, and scalar ones only where ALLOW_LIST says. Its lines are
`COUNT PATTERN`: at most COUNT scalar roots in functions whose name holds PATTERN; # is a comment.
"""

import re
import subprocess
import sys

import source_tree

PACKED = re.compile(r"\bv?sqrtp[sd]\b")
SCALAR = re.compile(r"\bv?sqrts[sd]\b")


def count_roots(objdump, objects):
    """{function: [packed, scalar]} for the functions that have any."""
    output = subprocess.run([objdump, "-d", "-C", "--no-show-raw-insn", *objects],
                            check=True, capture_output=True, text=True).stdout
    roots, function = {}, ""
    for line in output.splitlines():
        header = re.match(r"^[0-9a-f]+ <(.*)>:$", line)
        if header:
            function = header[1]
            continue
        packed, scalar = bool(PACKED.search(line)), bool(SCALAR.search(line))
        if packed or scalar:
            counts = roots.setdefault(function, [0, 0])
            counts[0] += packed
            counts[1] += scalar
    return roots


def read_allow_list(path):
    entries = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if line:
                count, pattern = line.split(maxsplit=1)
                entries.append((int(count), pattern))
    return entries


def check(objdump, namespace, allow_list, objects):
    roots = count_roots(objdump, objects)
    allowed = read_allow_list(allow_list)
    problems = []
    for function, (packed, scalar) in sorted(roots.items()):
        print(f"{packed:4} packed {scalar:4} scalar  {function}")
        limit = max((count for count, pattern in allowed if pattern in function), default=0)
        if scalar > limit:
            problems.append(f"{namespace}: {scalar} scalar roots, {limit} allowed: {function}")
        if not packed and not limit:
            problems.append(f"{namespace}: no packed square root: {function}")
    if not any(packed for packed, _ in roots.values()):
        problems.append(f"{namespace}: no packed square root at all (wrong object?)")
    return problems, f"{namespace}: {len(roots)} functions with square roots"


if __name__ == "__main__":
    source_tree.report("vectorised", *check(*sys.argv[1:4], sys.argv[4:]))
