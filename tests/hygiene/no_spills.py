"""Shows the registers of every GPU kernel, and fails when one of them spills.

usage: no_spills.py CXXFILT OBJECT...
What `nvcc -Xptxas -v` printed lies next to each object (cmake/keep_ptxas.py): an entry function,
its spills and its registers, for each architecture. Sorts are Thrust's own affair.
"""

import os
import re
import subprocess
import sys

import source_tree

# Triangles in double precision: more values are alive than a thread has registers (255), since the
# normal where a substep began is looked for as well, and in the position form a way along the
# surface. Bytes that this rare pass may spill; the figure is to go down, not up.
MAY_SPILL = {"CollidePass<double, Meets::meshes>": 2060}

ENTRY = re.compile(r"Compiling entry function '(\S+)' for '(\S+)'")
SPILLS = re.compile(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads")
USED = re.compile(r"Used (\d+) registers")


def short(name):
    """The kernel of `void weft::cuda::run_blocks<KERNEL>(int, KERNEL)`."""
    found = re.match(r"void weft::\w+::run_blocks<(.*)>\(int, ", name)
    name = found[1] if found else name
    name = re.sub(r"weft::(cuda::|hip::)?", "", name)
    name = re.sub(r"\(Meets\)(\d)", lambda m: "Meets::" + ("all", "shapes", "meshes")[int(m[1])],
                  name)
    # Sets of stages (step/variants.h) by how many they lack, whatever the number of a stage is.
    name = re.sub(r"\b(\d{10})u\b", lambda m: {1: "in_wind", 2: "in_still_air"}.get(
        bin(int(m[1]) ^ 0xffffffff).count("1"), m[0]), name)
    return name.replace(" >", ">").strip()


def kernels(text, demangle):
    """(name, architecture, stack, spilled, registers) of each; functions that it calls count."""
    found = []
    for part in text.split("ptxas info    : Compiling entry function ")[1:]:
        entry = ENTRY.search("Compiling entry function " + part)
        used = USED.search(part)
        memory = [tuple(map(int, match)) for match in SPILLS.findall(part)]
        if not entry or not used or not memory:
            continue
        found.append((demangle(entry[1]), entry[2], max(m[0] for m in memory),
                      sum(m[1] + m[2] for m in memory), int(used[1])))
    return found


def check(text, demangle):
    rows = [(short(name), *rest) for name, *rest in kernels(text, demangle)
            if "run_blocks" in name]
    problems = []
    if not rows:
        problems.append("no kernel was found (is it the output of nvcc -Xptxas -v?)")
    for name, architecture, _, spilled, registers in rows:
        if spilled > MAY_SPILL.get(name, 0):
            problems.append(f"{name} spills {spilled} bytes on {architecture} ({registers} "
                            "registers): give the hungry stage a pass of its own")
    table = [f"{registers:4d} registers {stack:5d} B stack {spilled:4d} B spilled  {name} "
             f"{architecture}" for name, architecture, stack, spilled, registers in sorted(rows)]
    return problems, "\n".join([f"{len(rows)} kernels", *table])


def demangler(program):
    def demangle(name):
        done = subprocess.run([program, name], capture_output=True, text=True, check=True)
        return done.stdout.strip()
    return demangle


if __name__ == "__main__":
    outputs = []
    for path in (name + ".ptxas" for name in sys.argv[2:]):
        if os.path.exists(path):
            with open(path, encoding="utf-8") as kept:
                outputs.append(kept.read())
    source_tree.report("no_spills", *check("\n".join(outputs), demangler(sys.argv[1])))
