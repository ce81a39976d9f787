"""Checks that the library without a GPU back end needs no GPU runtime.

usage: cpu_library.py NM LIBRARY
"""

import re
import subprocess
import sys

import source_tree

GPU_SYMBOL = re.compile(r"^(__cuda|cuda[A-Z]|cu[A-Z]|__hip|hip[A-Z])")


def check(nm, library):
    output = subprocess.run([nm, "--undefined-only", "--no-demangle", library],
                            check=True, capture_output=True, text=True).stdout
    needed = {line.split()[-1] for line in output.splitlines() if " U " in line}
    problems = [f"{library} needs {name}" for name in sorted(needed) if GPU_SYMBOL.match(name)]
    return problems, f"{len(needed)} symbols needed, none of a GPU runtime"


if __name__ == "__main__":
    source_tree.report("cpu_library", *check(*sys.argv[1:3]))
