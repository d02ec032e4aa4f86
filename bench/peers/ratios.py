# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints Exudyn's runs beside ancf's cheapest of an equal or smaller error.

    ratios.py FOLDER [--markdown]    reads FOLDER/exudyn-*.csv and FOLDER/ancf-*.csv; exits 1 without runs of both
"""

import csv
import pathlib
import sys

PLANAR = ("planar", "planar-cable", "planar-continuum")


def rows(folder, code):
    """Rows by what was run, with the least time of all rounds."""
    best = {}
    for path in sorted(pathlib.Path(folder).glob(f"{code}-*.csv")):
        with open(path, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                key = tuple(value for name, value in row.items() if name not in ("cpu_ms", "iterations"))
                row["cpu_ms"], row["error"] = float(row["cpu_ms"]), float(row["error"])
                if key not in best or row["cpu_ms"] < best[key]["cpu_ms"]:
                    best[key] = row
    return list(best.values())


def kind(element):
    """In the plane or in space, with shear or without."""
    return element in PLANAR or "2d" in element, "cable" in element


def pairs(folder):
    """Each run of Exudyn that no other of its element beats, with ancf's cheapest of at most its error."""
    exudyn, ours = rows(folder, "exudyn"), rows(folder, "ancf")
    for code, runs in (("exudyn", exudyn), ("ancf", ours)):
        if not runs:
            sys.exit(f"ratios.py: no run in {folder}/{code}-*.csv")
    for peer in exudyn:
        rivals = [row for row in ours if row["case"] == peer["case"] and row["error"] <= peer["error"]
                  and kind(row["element"]) == kind(peer["element"])]
        yield peer, min(rivals, key=lambda row: row["cpu_ms"], default=None)


def main(folder, *options):
    markdown = "--markdown" in options
    found_pairs = list(pairs(folder))  # before anything is printed
    line = "| {} | {} | {} | {:.1e} | {:.3f} | {} | {} | {} |" if markdown else \
        "{:11} {:14} {:>3} {:9.1e} {:9.3f}  {:38} {:>9} {:>7}"
    if markdown:
        print("| case | Exudyn's element | n | error | ms | ancf, at most that error | ms | ratio |\n|---|---|---|---|---|---|---|---|")
    else:
        print("case        Exudyn           n     error        ms  ancf, at most that error                      ms   ratio")
    for peer, own in found_pairs:
        found = ("none", "", "") if own is None else (
            f"{own['element']} {own['rule']} n={own['elements']} {own['solver']}", f"{own['cpu_ms']:.3f}",
            f"{peer['cpu_ms'] / own['cpu_ms']:.1f}")
        print(line.format(peer["case"], peer["element"], peer["elements"], peer["error"], peer["cpu_ms"], *found))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
