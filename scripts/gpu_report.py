"""Reads what scripts/gpu_check.sh left in a folder.
usage: gpu_report.py tests|parity|bench|report FOLDER
       gpu_report.py remaining FOLDER PROGRAM GROUPS
The first three print a summary and fail when something failed; `report` prints Markdown;
`remaining` prints at most GROUPS filters for the tests of PROGRAM that have not ended yet."""

import csv
import glob
import itertools
import json
import os
import re
import subprocess
import sys


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


def read(path):
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


# Tests: a log per program and group; one that was cut off leaves tests for the next call.


def read_tests(folder):
    """By program: names of those that passed, were skipped, failed, and did not end."""
    programs = {}
    for path in sorted(glob.glob(f"{folder}/tests/*.log")):
        text = read(path)
        program = os.path.basename(path).rsplit(".", 2)[0]
        passed, skipped, failed, broken = programs.setdefault(program, ([], [], [], []))
        passed += re.findall(r"^\[       OK \] (\S+)", text, re.M)
        skipped += re.findall(r"^\[  SKIPPED \] (\S+?)(?: \(|,)", text, re.M)
        ended = re.search(r"^\[==========\] .* ran\.", text, re.M)
        failed += sorted(set(re.findall(r"^\[  FAILED  \] (\S+?)(?: \(|,)", text, re.M)))
        if not ended:
            running = re.findall(r"^\[ RUN      \] (\S+)", text, re.M)
            broken.append(running[-1] if running else os.path.basename(path))
    for passed, skipped, failed, broken in programs.values():
        broken[:] = sorted(set(broken) - set(passed) - set(skipped) - set(failed))
    return programs


def remaining(folder, program, groups):
    listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True,
                            check=True).stdout
    names, suite = [], ""
    for line in listed.splitlines():
        name = line.split("#")[0].strip()
        if line.startswith(" "):
            names.append(suite + name)
        elif name.endswith("."):
            suite = name
    ended = set()
    for kind in read_tests(folder).get(os.path.basename(program), ())[:3]:
        ended.update(kind)
    left = [name for name in names if name not in ended]
    for group in range(min(groups, len(left))):
        print(":".join(left[group::groups]))


def tests_table(folder):
    lines = ["| program | passed | skipped | failed |", "|---|---|---|---|"]
    details, good = [], True
    for program, (passed, skipped, failed, broken) in read_tests(folder).items():
        lines.append(f"| {program} | {len(passed)} | {len(skipped)} | {len(failed)} |")
        details += [f"- {program}: {name} failed" for name in failed]
        details += [f"- {program}: ended in {name}" for name in broken]
        good = good and not failed and not broken and passed
    if len(lines) == 2:
        return "no tests were run", False
    return "\n".join(lines + ([""] + details if details else [])), bool(good)


# Parity: the final state of every scene, written by both back ends.


def first_difference(a, b):
    """None, or a sentence about the first vertex whose digits differ."""
    with open(a, encoding="utf-8") as one, open(b, encoding="utf-8") as other:
        for left, right in itertools.zip_longest(csv.reader(one), csv.reader(other)):
            if left == right:
                continue
            if left is None or right is None:
                return "one file has more vertices"
            return f"cloth {left[0]} vertex {left[1]}: omp {left[2:]}, cuda {right[2:]}"
    return None


def parity_table(folder):
    lines = ["| scene | particles | steps | state hash on omp | on cuda | ms/frame omp | cuda |",
             "|---|---|---|---|---|---|---|"]
    details, good = [], True
    for path in sorted(glob.glob(f"{folder}/parity/*.omp.json")):
        scene = path[: -len(".omp.json")]
        other = scene + ".cuda.json"
        if not os.path.exists(other):
            details.append(f"- {os.path.basename(scene)}: did not run on cuda")
            good = False
            continue
        host, gpu = json.loads(read(path)), json.loads(read(other))
        frame = [1e3 * r["wall_seconds"] / max(r["frames"], 1) for r in (host, gpu)]
        lines.append(f"| {os.path.basename(scene)} | {host['particles']} | {host['steps']} "
                     f"| {host['state_hash']} | {gpu['state_hash']} "
                     f"| {frame[0]:.3f} | {frame[1]:.3f} |")
        difference = first_difference(scene + ".omp.csv", scene + ".cuda.csv")
        if host["state_hash"] != gpu["state_hash"] or difference:
            good = False
            details.append(f"- {os.path.basename(scene)}: {difference or 'the hashes differ'}")
    if len(lines) == 2:
        return "no scene was run", False
    return "\n".join(lines + ([""] + details if details else [])), good


# Benchmarks.


def bench_table(folder):
    text = read(f"{folder}/bench.json")
    if not text.strip():
        return "no benchmark was run", False
    rows = json.loads(text)["rows"]
    lines = ["| case | metric | median | least | most | n |", "|---|---|---|---|---|---|"]
    for row in rows:
        unit = "" if row["unit"] == "1" else " " + row["unit"]
        lines.append(f"| {row['case']} | {row['metric']} | {row['median']:.4g}{unit} "
                     f"| {row['min']:.4g} | {row['max']:.4g} | {row['n']} |")
    return "\n".join(lines), len(rows) > 0


def sanitizer_table(folder):
    lines = ["| tool | result |", "|---|---|"]
    for path in sorted(glob.glob(f"{folder}/sanitize/*.log")):
        found = re.findall(r"=========\s*((?:ERROR|RACECHECK) SUMMARY.*)", read(path))
        lines.append(f"| {name_of(path)} | {found[-1] if found else 'did not finish'} |")
    return "\n".join(lines) if len(lines) > 2 else "compute-sanitizer was not run"


def report(folder):
    machine = read(f"{folder}/machine.txt").strip().splitlines()
    print("# GPU check\n")
    print("Made by `scripts/gpu_check.sh`. Device, compiler, commit and date:\n")
    for line in machine or ["no NVIDIA GPU: nothing was measured"]:
        print(f"- {line}")
    passed = {name_of(path) for path in glob.glob(f"{folder}/*.done")}
    print("\n| stage | outcome |\n|---|---|")
    for stage in ("build", "tests", "parity", "sanitize", "bench"):
        print(f"| {stage} | {'passed' if stage in passed else 'FAILED or not run'} |")
    for title, text in (("Tests, their worlds on the GPU", tests_table(folder)[0]),
                        ("Parity with the host, sample scenes to their end",
                         parity_table(folder)[0]),
                        ("compute-sanitizer", sanitizer_table(folder)),
                        ("Benchmarks (`weft bench gpu`)", bench_table(folder)[0])):
        print(f"\n## {title}\n\n{text}")


def main():
    tables = {"tests": tests_table, "parity": parity_table, "bench": bench_table}
    if len(sys.argv) == 5 and sys.argv[1] == "remaining":
        remaining(sys.argv[2], sys.argv[3], int(sys.argv[4]))
        return
    if len(sys.argv) != 3 or sys.argv[1] not in (*tables, "report"):
        sys.exit(__doc__)
    what, folder = sys.argv[1:]
    if what == "report":
        report(folder)
        return
    text, good = tables[what](folder)
    print(text)
    if not good:
        sys.exit(1)


main()
