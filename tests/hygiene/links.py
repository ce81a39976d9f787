"""Checks that what the documents link to exists. usage: links.py PROJECT_ROOT"""

import os
import re
import sys

import source_tree

LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
HEADING = re.compile(r"^#+ +(.*?) *$", re.M)


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def anchors(text):
    """What #links to headings look like: lower case, words joined by -."""
    for heading in HEADING.findall(FENCE.sub(blank, text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        yield re.sub(r"[^\w\- ]", "", plain.lower()).strip().replace(" ", "-")


def problem_of(root, path, link):
    target, _, anchor = link.partition("#")
    file = os.path.normpath(os.path.join(os.path.dirname(path), target)) if target else path
    if file.startswith("..") or os.path.isabs(target):
        return "leads out of the project"
    if not os.path.exists(os.path.join(root, file)):
        return f"{file} does not exist"
    if anchor and anchor not in anchors(source_tree.read(root, file)):
        return f"{file} has no heading #{anchor}"
    return None


def check(root):
    problems, count = [], 0
    for path in source_tree.files(root, (".md",)):
        text = FENCE.sub(blank, source_tree.read(root, path))
        for match in LINK.finditer(text):
            if re.match(r"(https?|mailto):", match[1]):
                continue
            count += 1
            problem = problem_of(root, path, match[1])
            if problem:
                line = text.count("\n", 0, match.start()) + 1
                problems.append(f"{path}:{line}: {match[1]}: {problem}")
    if count == 0:
        problems.append("no link was found in any document")
    return problems, f"{count} links"


if __name__ == "__main__":
    source_tree.report("links", *check(sys.argv[1]))
