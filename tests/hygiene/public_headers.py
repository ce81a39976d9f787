"""Compiles every public header alone. usage: public_headers.py INCLUDE_FOLDER COMPILER...

Each header must be complete in itself, includable twice, and free of warnings without exceptions
and RTTI, as C++17 and C++20.
"""

import os
import subprocess
import sys
import tempfile

import source_tree

FLAGS = ["-fsyntax-only", "-fno-exceptions", "-fno-rtti",
         "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]


def check(include, compilers):
    problems = []
    headers = source_tree.files(include, (".hpp",))
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "alone.cpp")
        for header in headers:
            with open(source, "w", encoding="utf-8") as file:
                file.write(f'#include "{header}"\n#include "{header}"\n')
            for compiler in compilers:
                for standard in ("-std=c++17", "-std=c++20"):
                    command = [compiler, standard, *FLAGS, "-I", include, source]
                    done = subprocess.run(command, capture_output=True, text=True)
                    if done.returncode:
                        problems.append(f"{header} ({compiler} {standard}):\n{done.stderr}")
    if not headers:
        problems.append(f"no header under {include} (the check would pass for nothing)")
    return problems, f"{len(headers)} headers, {', '.join(map(os.path.basename, compilers))}"


if __name__ == "__main__":
    source_tree.report("public_headers", *check(sys.argv[1], sys.argv[2:]))
