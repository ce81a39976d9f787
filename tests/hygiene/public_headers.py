"""Compiles every public header alone. usage: public_headers.py INCLUDE_FOLDER COMPILER...

Each header must be complete in itself, includable twice, and free of warnings without exceptions
and RTTI, as C++17 and C++20; those that end in .h as C11 too.
"""

import os
import subprocess
import sys
import tempfile

import source_tree

WARNINGS = ["-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
CXX = ["-x", "c++", "-fno-exceptions", "-fno-rtti"]
WAYS = {".hpp": [[*CXX, "-std=c++17"], [*CXX, "-std=c++20"]],
        ".h": [[*CXX, "-std=c++17"], ["-x", "c", "-std=c11"]]}


def check(include, compilers):
    problems = []
    headers = source_tree.files(include, tuple(WAYS))
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "alone.cpp")
        for header in headers:
            with open(source, "w", encoding="utf-8") as file:
                file.write(f'#include "{header}"\n#include "{header}"\n')
            for compiler in compilers:
                for way in WAYS[os.path.splitext(header)[1]]:
                    command = [compiler, *way, *WARNINGS, "-I", include, source]
                    done = subprocess.run(command, capture_output=True, text=True)
                    if done.returncode:
                        problems.append(f"{header} ({compiler} {way[-1]}):\n{done.stderr}")
    if not headers:
        problems.append(f"no header under {include} (the check would pass for nothing)")
    return problems, f"{len(headers)} headers, {', '.join(map(os.path.basename, compilers))}"


if __name__ == "__main__":
    source_tree.report("public_headers", *check(sys.argv[1], sys.argv[2:]))
