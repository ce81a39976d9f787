"""Compiler launcher: runs nvcc and keeps what its assembler says of registers and spills.

usage: keep_ptxas.py [LAUNCHER...] nvcc ARGUMENTS... The output goes to OBJECT.ptxas, next to the
object; what is about anything else, warnings for example, is printed as ever.
"""

import re
import subprocess
import sys

ABOUT_REGISTERS = re.compile(r"^(ptxas info|\s+\d+ bytes stack frame)")


def main(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    others = [line for line in done.stdout.splitlines() if not ABOUT_REGISTERS.match(line)]
    if others:
        print("\n".join(others), file=sys.stderr)
    if "-o" in command and done.returncode == 0:
        with open(command[command.index("-o") + 1] + ".ptxas", "w", encoding="utf-8") as file:
            file.write(done.stdout)
    return done.returncode


sys.exit(main(sys.argv[1:]))
