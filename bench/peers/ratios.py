# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints Exudyn and ancf side by side at equal error.

    ratios.py FOLDER [--markdown]    reads FOLDER/exudyn-*.csv and FOLDER/ancf-*.csv; exits 1 without runs of both

First, for some bounds of the error, the cheapest run of each code; then each run of Exudyn that no other of its kind of
element is as cheap and as exact as, beside the cheapest of ancf with at most its error. Errors are sure errors (fronts.py), and a
kind is in the plane or in space, cable or beam with shear. A ratio above 1 is in favour of ancf.
"""

import sys

import fronts

CASES = {"model2": "Model II", "semicircle": "semicircle", "pendulum": "pendulum"}


def by_kind(folder):
    """(case, kind, Exudyn's runs, ancf's runs) wherever there are runs of Exudyn."""
    both = fronts.runs_in(folder, "exudyn"), fronts.runs_in(folder, "ancf")
    for code, runs in zip(("exudyn", "ancf"), both):
        if not runs:
            raise FileNotFoundError(f"no run in {folder}/{code}-*.csv")
    for case in CASES:
        of_case = [[run for run in runs if run["case"] == case] for runs in both]
        for kind in sorted({fronts.kind(run["element"]) for run in of_case[0]}):
            yield case, kind, *([run for run in runs if fronts.kind(run["element"]) == kind] for runs in of_case)


def cells(peer, own):
    """What was run and its milliseconds, for both, and the ratio."""
    run_cells = [cell for run in (peer, own)
                 for cell in ((fronts.name_of(run), f"{run['cpu_ms']:.3g}") if run else ("none", ""))]
    return [*run_cells, f"{peer['cpu_ms'] / own['cpu_ms']:.2g}" if peer and own else ""]


def below_bounds(folder):
    """Header and rows: the cheapest run of each code below each bound."""
    rows = []
    for case, kind, exudyn, ours in by_kind(folder):
        for bound in fronts.BOUNDS:
            found = fronts.cheapest(exudyn, bound), fronts.cheapest(ours, bound)
            if any(found):
                rows.append([CASES[case], kind, f"{bound:.0e}", *cells(*found)])
    return ["case", "kind", "error below", "Exudyn", "ms", "ancf", "ms", "ratio"], rows


def beside_front(folder):
    """Header and rows: each run of Exudyn's fronts and the cheapest of ancf with at most its error."""
    rows = [[CASES[case], kind, f"{peer['sure']:.1e}", *cells(peer, fronts.cheapest(ours, peer["sure"]))]
            for case, kind, exudyn, ours in by_kind(folder) for peer in fronts.front(exudyn)]
    return ["case", "kind", "error", "Exudyn", "ms", "ancf, at most that error", "ms", "ratio"], rows


def markdown(header, rows):
    head, *lines = ("| " + " | ".join(map(str, line)) + " |" for line in (header, *rows))
    return "\n".join([head, "|" + "---|" * len(header), *lines]) + "\n"


def plain(header, rows):
    widths = [max(map(len, column)) for column in zip(header, *rows)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in (header, *rows)) + "\n"


def main(folder, *options):
    write = markdown if "--markdown" in options else plain
    try:
        tables = [write(*below_bounds(folder)), write(*beside_front(folder))]
    except FileNotFoundError as missing:
        sys.exit(f"ratios.py: {missing}")
    print("\n".join(tables), end="")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
