"""What the pages made of `weft bench NAME --json` have in common: rows, tables, plots."""

import json
import re
import subprocess


class Rows:
    """The rows of one table, by case and metric."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.rows = json.load(file)["rows"]
        self.of = {(r["case"], r["metric"]): r["median"] for r in self.rows}

    def get(self, case, metric, default=None):
        return self.of.get((case, metric), default)

    def cases(self, pattern, metric):
        found = [r["case"] for r in self.rows if r["metric"] == metric]
        return [re.match(pattern, case) for case in found if re.match(pattern, case)]


def number(value, digits=3):
    return "" if value is None else f"{value:.{digits}g}"


def table(header, lines):
    yield "| " + " | ".join(header) + " |"
    yield "|---|" + "---:|" * (len(header) - 1)
    for line in lines:
        yield "| " + " | ".join(line) + " |"
    yield ""


def plot(path, title, axes, series, extra=""):
    """`series`: (name, [(x, y), ...])."""
    script = ['set terminal svg size 720,400 dynamic background "white" font "sans,13"',
              f'set output "{path}"', f'set title "{title}"', "set key outside right noenhanced",
              "set grid", "set xtics noenhanced",
              f'set xlabel "{axes[0]}"', f'set ylabel "{axes[1]}"', extra]
    for index, (_, points) in enumerate(series):
        script.append(f"$d{index} << E")
        script += [" ".join(str(v) for v in p) for p in points if p[1] is not None]
        script.append("E")
    using = "2:xtic(1)" if "xtics" in extra else "1:2"
    script.append("plot " + ", ".join(
        f'$d{i} using {using} with linespoints pt 7 lw 2 title "{name}"'
        for i, (name, _) in enumerate(series)))
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
