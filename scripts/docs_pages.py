"""Gathers the pages of the documents' site. usage: docs_pages.py PROJECT_ROOT PAGES

The project's Markdown files keep their places, and every file that they name comes along, so that
links need no change. A folder that they name gets a page that lists it."""

import os
import re
import shutil
import sys

LINK = re.compile(r"(?<=\]\()([^)#\s]+)(?=(#[^)\s]*)?\))")
PAGES = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")


def copy(root, pages, path):
    target = os.path.join(pages, path)
    os.makedirs(os.path.dirname(target), exist_ok=True)
    shutil.copyfile(os.path.join(root, path), target)


def list_folder(root, pages, folder):
    """The page of a folder: its own README.md, or a list of its files."""
    index = os.path.join(folder, "README.md")
    if os.path.exists(os.path.join(root, index)):
        return index
    entries = sorted(e for e in os.listdir(os.path.join(root, folder))
                     if os.path.isfile(os.path.join(root, folder, e)))
    target = os.path.join(pages, folder, "index.md")
    os.makedirs(os.path.dirname(target), exist_ok=True)
    with open(target, "w", encoding="utf-8") as file:
        file.write(f"# {folder}\n\n" + "".join(f"- [{e}]({e})\n" for e in entries))
    for entry in entries:
        copy(root, pages, os.path.join(folder, entry))
    return os.path.join(folder, "index.md")


def gather(root, pages, todo):
    done = set()
    while todo:
        page = todo.pop()
        if page in done:
            continue
        done.add(page)
        here = os.path.dirname(page)

        def place(match):
            link = match[0]
            if "://" in link:
                return link
            path = os.path.normpath(os.path.join(here, link))
            if os.path.isdir(os.path.join(root, path)):
                path = list_folder(root, pages, path)
            elif not path.endswith(".md"):
                copy(root, pages, path)
            if path.endswith("README.md"):
                todo.append(path)
            return os.path.relpath(path, here or ".")

        with open(os.path.join(root, page), encoding="utf-8") as file:
            text = LINK.sub(place, file.read())
        target = os.path.join(pages, page)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "w", encoding="utf-8") as file:
            file.write(text)


def main(root, pages):
    docs = [f"docs/{name}" for name in sorted(os.listdir(os.path.join(root, "docs")))
            if name.endswith(".md")]
    gather(root, pages, [*PAGES, *docs])


main(*sys.argv[1:])
