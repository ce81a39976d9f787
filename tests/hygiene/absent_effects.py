"""Shows that an effect which a scene does not name costs nothing.

usage: absent_effects.py VALGRIND PROGRAM BARE

PROGRAM and BARE step the same sheet without effects; in BARE the stages of all optional effects are
not even compiled (src/state/stages.h). The instructions of a frame, counted by callgrind and thus
repeatable, may be more by 1 % at most (fewer they can be: a compiler's choices differ), the bytes
the same.
"""

import re
import subprocess
import sys
import tempfile

MOST_DIFFERENCE = 0.01
FRAMES = (1, 6)


def run(valgrind, program, frames):
    """(instructions, bytes of the state)"""
    with tempfile.NamedTemporaryFile() as out:
        command = [valgrind, "--tool=callgrind", f"--callgrind-out-file={out.name}", program,
                   str(frames)]
        done = subprocess.run(command, capture_output=True, text=True)
        found = re.search(r"Collected\s*:\s*(\d+)", done.stderr)
        if done.returncode != 0 or not found:
            sys.exit(f"absent_effects: {' '.join(command)} failed\n{done.stderr}")
        return int(found[1]), int(done.stdout)


def main(valgrind, programs):
    per_frame, held = [], []
    for program in programs:
        few, bytes_few = run(valgrind, program, FRAMES[0])
        many, _ = run(valgrind, program, FRAMES[1])
        per_frame.append((many - few) / (FRAMES[1] - FRAMES[0]))
        held.append(bytes_few)
    difference = per_frame[0] / per_frame[1] - 1
    print(f"instructions per frame: {per_frame[0]:.0f} with all stages, {per_frame[1]:.0f} without "
          f"({100 * difference:+.3f} %); bytes of the state: {held[0]} and {held[1]}")
    if difference > MOST_DIFFERENCE or held[0] != held[1]:
        sys.exit("absent_effects: a stage that is not used costs something")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:4])
