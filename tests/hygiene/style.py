"""Checks what of the style can be counted. usage: style.py PROJECT_ROOT"""

import re
import sys

import source_tree

CMAKE = (".cmake", "CMakeLists.txt")
CODE = source_tree.CXX + CMAKE + (".py", ".sh", ".ci/run")
LONGEST_FILE = 400
LONGEST_FILE_P90 = 300
LONGEST_LINE = 100
LONGEST_CMAKE_LINE = 120  # lists of targets, flags and folders read better in one piece
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")


def too_long(path, line):
    if not path.endswith(CMAKE):
        return len(line) > LONGEST_LINE
    return len(line) > LONGEST_CMAKE_LINE and "message(" not in line


def check_file(path, lines):
    if len(lines) > LONGEST_FILE:
        yield f"{path}: {len(lines)} lines (at most {LONGEST_FILE}): split the file"
    for number, line in enumerate(lines, 1):
        if too_long(path, line):
            yield f"{path}:{number}: the line has {len(line)} columns (at most {LONGEST_LINE})"
        if "\t" in line:
            yield f"{path}:{number}: the line has a tab"
        if UNFINISHED.search(line):
            yield f"{path}:{number}: unfinished work belongs in an issue"


def check(root):
    problems, lengths = [], []
    for path in source_tree.files(root, CODE):
        lines = source_tree.read(root, path).split("\n")[:-1]
        lengths.append(len(lines))
        problems += check_file(path, lines)
    lengths.sort()
    median, p90 = (lengths[int(len(lengths) * part)] for part in (0.5, 0.9))
    if p90 > LONGEST_FILE_P90:
        problems.append(f"one file in ten has {p90} lines or more (at most {LONGEST_FILE_P90})")
    return problems, f"{len(lengths)} files, lines: median {median}, p90 {p90}, most {lengths[-1]}"


if __name__ == "__main__":
    source_tree.report("style", *check(sys.argv[1]))
