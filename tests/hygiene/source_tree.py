"""What the hygiene checks share: the project's files and their text."""

import os
import re
import sys

SKIPPED_FOLDERS = re.compile(r"^(\.(?!ci$).*|build.*|out|__pycache__)$")
CXX = (".h", ".hpp", ".cpp", ".cu", ".cuh")


def files(root, suffixes):
    """The files that end in one of `suffixes`, relative to `root`, with /, sorted."""
    found = []
    for folder, subfolders, names in os.walk(root):
        subfolders[:] = sorted(s for s in subfolders if not SKIPPED_FOLDERS.match(s))
        for name in names:
            if name.endswith(suffixes):
                found.append(os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/"))
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def without_comments(text):
    """C++ text with its comments blanked; lines keep their numbers, string literals stay."""
    token = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/', re.S)

    def blank(match):
        comment = match.group().startswith(("//", "/*"))
        return re.sub(r"[^\n]", " ", match.group()) if comment else match.group()

    return token.sub(blank, text)


def report(name, problems, passed):
    """Prints the outcome and ends the program: 1 when there are problems."""
    for problem in problems:
        print(problem)
    if problems:
        print(f"{name}: {len(problems)} problem(s)")
        sys.exit(1)
    print(f"{name}: {passed}")
    sys.exit(0)
