"""Checks who includes whom. usage: layers.py PROJECT_ROOT

The layers are those of docs/architecture.md. A folder may include itself, include/weft and what
MAY_INCLUDE lists for it, nothing else.
"""

import posixpath
import re
import sys

import source_tree


def rooms(folder, names, below):
    """Rooms of a folder from low to high: each may include those before it and what is below."""
    return {f"{folder}/{name}": below + [f"{folder}/{lower}" for lower in names[:k]]
            for k, name in enumerate(names)}


MAY_INCLUDE = {
    "include/weft": [],
    "src/base": [],
    "src/state": ["src/base"],
    "src/kernels": ["src/base", "src/state"],
    "src/kernels/measured": ["src/base", "src/state", "src/kernels"],
    "src/scene": ["src/base"],
    "src/plan": ["src/base", "src/scene", "src/state"],
    "src/step": ["src/base", "src/state", "src/kernels", "src/kernels/measured", "src/plan"],
    "src/omp": ["src/base", "src/state", "src/scene", "src/plan", "src/kernels", "src/step"],
    "src/cuda": ["src/base", "src/state", "src/scene", "src/plan", "src/kernels", "src/step"],
    **rooms("src/api", ["context", "records", "arena", "world"],
            ["src/base", "src/scene", "src/plan", "src/step/backend.h"]),
    "src/api/c": [],
    "src/io": [],
    "src/render": ["src/io"],
    "tools": ["src/io", "src/render", "bench"],
    "bench": ["src/io", "tools", "samples/effects", "src/omp/sort.h"],
    "samples/effects": [],
    "samples": ["src/io"],
}

# Folders that one file alone enters.
GATES = {"src/kernels/measured": "src/step/measured.h"}

# Headers without functions that a linker could take from the AVX-512 copy for everybody.
ISA_SAFE_HEADERS = set("""
cassert cfloat climits cmath cstddef cstdint cstring limits new type_traits
immintrin.h linux/futex.h omp.h sched.h stddef.h stdint.h stdlib.h string.h sys/syscall.h time.h
unistd.h
""".split())
ISA_ROOTS = ["src/omp/backend.cpp", "src/omp/exec.h", "src/omp/memory.h"]
ISA_FOLDERS = ["src/base", "src/state", "src/kernels", "src/kernels/measured", "src/step"]

# Where the headers of others may be included (tests may include any).
THIRD_PARTY = [
    (re.compile(r"^(cuda|hip/|rocprim|cooperative_groups)"), ["src/cuda/"]),
    (re.compile(r"^(thrust|cub)/"), ["src/omp/sort.cpp", "src/cuda/"]),
    (re.compile(r"^Eigen/"), ["src/scene/", "src/render/"]),
    (re.compile(r"^(epoxy/|png[.]h)"), ["src/render/"]),
    (re.compile(r"^nlohmann/"), ["src/io/", "tools/", "bench/"]),
    (re.compile(r"^CLI/"), ["tools/"]),
]

GPU_COMPILER_MACRO = re.compile(r"\b__(CUDACC|HIPCC|CUDA_ARCH|HIP_DEVICE_COMPILE|NVCC|HIP)__\b")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.M)


def folder_of(path):
    holding = [folder for folder in MAY_INCLUDE if path.startswith(folder + "/")]
    if holding:
        return max(holding, key=len)
    return path.split("/")[0] if not path.startswith("src/") else posixpath.dirname(path)


class Tree:
    def __init__(self, root):
        self.text = {path: source_tree.without_comments(source_tree.read(root, path))
                     for path in source_tree.files(root, source_tree.CXX)}
        self.problems = []
        self.edges = {path: [] for path in self.text}
        self.angled = {path: [] for path in self.text}

    def problem(self, path, line, text):
        self.problems.append(f"{path}:{line}: {text}")

    def resolve(self, path, name):
        """The project file that `name` means in `path`, or None."""
        for base in (posixpath.dirname(path), "src", "include", "", "tests"):
            candidate = posixpath.normpath(posixpath.join(base, name))
            if candidate in self.text:
                return candidate
        return None

    def read_includes(self):
        for path, text in self.text.items():
            for match in INCLUDE.finditer(text):
                quoted, angled = match.groups()
                line = text.count("\n", 0, match.start()) + 1
                target = self.resolve(path, quoted or angled)
                if angled:
                    self.angled[path].append((line, angled))
                    if target and "/" in angled:
                        self.problem(path, line, f"<{angled}> is ours: write it in quotes")
                elif not target:
                    self.problem(path, line, f'"{quoted}" is not a file of ours: write <...>')
                else:
                    self.check_spelling(path, line, quoted, target)
                    self.edges[path].append((line, target))

    def check_spelling(self, path, line, name, target):
        root = "include/" if target.startswith("include/") else "src/"
        if target.startswith(root) and name != target[len(root):]:
            self.problem(path, line, f'"{name}" must be written "{target[len(root):]}"')

    def check_layers(self):
        for path, includes in self.edges.items():
            here = folder_of(path)
            if here == "tests":
                continue
            if here not in MAY_INCLUDE:
                self.problem(path, 1, f"{here} is not a layer: add it to {__file__}")
                continue
            for line, target in includes:
                there = folder_of(target)
                if there != here and path != GATES.get(there, path):
                    self.problem(path, line, f"only {GATES[there]} may include {there} ({target})")
                if there in (here, "include/weft") or there in MAY_INCLUDE[here]:
                    continue
                if target not in MAY_INCLUDE[here]:
                    self.problem(path, line, f"{here} must not include {there} ({target})")

    def check_cycles(self):
        files = {path: sorted({t for _, t in found}) for path, found in self.edges.items()}
        folders = {}
        for path, targets in files.items():
            here = folders.setdefault(folder_of(path), set())
            here.update(folder_of(t) for t in targets if folder_of(t) != folder_of(path))
        folders = {folder: sorted(targets) for folder, targets in folders.items()}
        for kind, graph in (("file", files), ("folder", folders)):
            cycle = find_cycle(graph)
            if cycle:
                self.problems.append(f"{kind} include cycle: " + " -> ".join(cycle))

    def check_gpu_macros(self):
        for path, text in self.text.items():
            if path == "src/base/portability.h":
                continue
            for match in GPU_COMPILER_MACRO.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                self.problem(path, line, f"only src/base/portability.h may name {match.group()}")

    def check_third_party(self):
        for path, found in self.angled.items():
            for line, name in found:
                for pattern, places in THIRD_PARTY:
                    if pattern.match(name) and not path.startswith(("tests/", *places)):
                        self.problem(path, line, f"<{name}> belongs in {' or '.join(places)}")

    def check_suffixes(self):
        for path in self.text:
            if path.endswith((".cu", ".cuh")) and not path.startswith("src/cuda/"):
                self.problem(path, 1, "files of the GPU compiler live in src/cuda")

    def check_kernels(self):
        for path, text in self.text.items():
            if not path.startswith("src/kernels/"):
                continue
            for match in re.finditer(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else)\b", text, re.M):
                line = text.count("\n", 0, match.start()) + 1
                self.problem(path, line, f"no #{match[1]}: a kernel is one text for all")

    def check_isa_objects(self):
        """What ISA objects see has no standard container, algorithm, stream, Thrust or Eigen."""
        seen, todo = set(), [p for p in ISA_ROOTS if p in self.text]
        todo += [p for p in self.text if p.endswith(".h") and not p.endswith("_host.h")
                 and posixpath.dirname(p) in ISA_FOLDERS]
        while todo:
            path = todo.pop()
            if path in seen:
                continue
            seen.add(path)
            todo += [target for _, target in self.edges[path]]
            for line, name in self.angled[path]:
                if name not in ISA_SAFE_HEADERS:
                    self.problem(path, line, f"<{name}> is seen by an ISA object "
                                             "(its inline functions would serve all levels)")


def find_cycle(graph):
    """A cycle of `graph` {node: [node]} as a list whose ends are equal, or None."""
    state = {}

    def visit(node, trail):
        state[node] = "open"
        for target in graph.get(node, []):
            if state.get(target) == "open":
                return trail[trail.index(target):] + [target]
            if target not in state:
                found = visit(target, trail + [target])
                if found:
                    return found
        state[node] = "done"
        return None

    for node in sorted(graph):
        if node not in state:
            found = visit(node, [node])
            if found:
                return found
    return None


def check(root):
    tree = Tree(root)
    tree.read_includes()
    for rule in (tree.check_layers, tree.check_cycles, tree.check_gpu_macros,
                 tree.check_third_party, tree.check_suffixes, tree.check_kernels,
                 tree.check_isa_objects):
        rule()
    return tree


if __name__ == "__main__":
    checked = check(sys.argv[1])
    includes = sum(len(found) for found in checked.edges.values())
    summary = f"{len(checked.text)} files, {includes} includes of ours"
    source_tree.report("layers", checked.problems, summary)
