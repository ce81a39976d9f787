"""Checks what the per-ISA objects define. usage: isa_symbols.py NM NAMESPACE OBJECT...

A function that two objects define is linked once, and the linker may keep the AVX-512 copy for a
processor that lacks it. So an object of level v4 defines nothing outside weft::omp_v4 except its
entry, weft::backend_omp_v4().
"""

import re
import subprocess
import sys

import source_tree

# Symbols that another object could be resolved to: text, weak, unique, data.
SHARED_TYPES = set("TWVuBDRi")


def defined_symbols(nm, objects):
    """(type, mangled name, readable name) of what `objects` define and a linker sees."""
    def lines(*options):
        command = [nm, "--no-sort", "--defined-only", *options, *objects]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        return done.stdout.splitlines()

    for mangled, readable in zip(lines("--no-demangle"), lines("--demangle"), strict=True):
        match = re.match(r"^[0-9a-f]* ([A-Za-z]) (.+)$", mangled)
        if match and match[1] in SHARED_TYPES:
            yield match[1], match[2], readable.split(maxsplit=2)[2]


def inside_pattern(namespace):
    """Mangled members of weft::NAMESPACE, their typeinfo, vtables, guards, statics; the entry.

    Two parts of the compilers' exception handling are in every object and hold no vector code.
    """
    entry = f"backend_{namespace}"
    return re.compile(rf"^_Z(TI|TS|TV|TT|GV)?Z*NK?4weft{len(namespace)}{namespace}\d"
                      rf"|^_ZN4weft{len(entry)}{entry}Ev$"
                      r"|^DW\.ref\.__gxx_personality_v0$|^__clang_call_terminate$")


def check(nm, namespace, objects):
    symbols = list(defined_symbols(nm, objects))
    inside = inside_pattern(namespace)
    problems = [f"{namespace}: outside weft::{namespace}: {kind} {readable}"
                for kind, mangled, readable in symbols if not inside.match(mangled)]
    if not any(readable == f"weft::backend_{namespace}()" for _, _, readable in symbols):
        problems.append(f"{namespace}: weft::backend_{namespace}() is missing (wrong object?)")
    return problems, f"{namespace}: {len(symbols)} symbols, all inside"


if __name__ == "__main__":
    source_tree.report("isa_symbols", *check(sys.argv[1], sys.argv[2], sys.argv[3:]))
