# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints other codes and ancf side by side at equal error.

    ratios.py FOLDER [--markdown]    reads FOLDER/CODE-*.csv of exudyn, chrono and ancf; exits 1 without ancf or any other

First, for some bounds of the error, the cheapest run of each code; then, for each other code, each run that no other of its kind of
element is as cheap and as exact as, beside the cheapest of ancf with at most its error. Errors are sure errors (fronts.py), and a
kind is in the plane or in space, cable or beam with shear. A ratio above 1 is in favour of ancf.
"""

import sys

import fronts

CASES = {"model2": "Model II", "semicircle": "semicircle", "pendulum": "pendulum"}
PEERS = {"exudyn": "Exudyn", "chrono": "Chrono"}


def by_kind(folder):
    """(case, kind, runs of each code by its name) wherever another code has runs; codes without any are left out."""
    codes = {code: runs for code in (*PEERS, "ancf") if (runs := fronts.runs_in(folder, code))}
    for missing in {"ancf"} - set(codes) or ({"exudyn"} if len(codes) == 1 else ()):
        raise FileNotFoundError(f"no run in {folder}/{missing}-*.csv")
    for case in CASES:
        for kind in sorted({fronts.kind(run["element"]) for code in codes if code != "ancf"
                            for run in codes[code] if run["case"] == case}):
            yield case, kind, {code: [run for run in runs if run["case"] == case and fronts.kind(run["element"]) == kind]
                               for code, runs in codes.items()}


def cells(run):
    """What was run and its milliseconds."""
    return [fronts.name_of(run), f"{run['cpu_ms']:.3g}"] if run else ["none", ""]


def ratio(peer, own):
    return f"{float(format(peer['cpu_ms'] / own['cpu_ms'], '.2g')):g}" if peer and own else ""


def below_bounds(folder):
    """Header and rows: the cheapest run of each code below each bound."""
    rows, peers = [], []
    for case, kind, codes in by_kind(folder):
        peers = [code for code in codes if code != "ancf"]
        for bound in fronts.BOUNDS:
            found = {code: fronts.cheapest(runs, bound) for code, runs in codes.items()}
            if any(found.values()):
                rows.append([CASES[case], kind, f"{bound:.0e}", *(cell for run in found.values() for cell in cells(run)),
                             *(ratio(found[code], found["ancf"]) for code in peers)])
    names = [cell for code in peers for cell in (PEERS[code], "ms")]
    return ["case", "kind", "error below", *names, "ancf", "ms",
            *(f"ratio to {PEERS[code]}" if len(peers) > 1 else "ratio" for code in peers)], rows


def beside_fronts(folder):
    """The name of each other code, header and rows: each run of its fronts and the cheapest of ancf with at most its error."""
    tables = {}
    for case, kind, codes in by_kind(folder):
        for code in codes:
            if code != "ancf":
                tables.setdefault(code, []).extend(
                    [CASES[case], kind, f"{peer['sure']:.1e}", *cells(peer), *cells(own), ratio(peer, own)]
                    for peer in fronts.front(codes[code]) for own in [fronts.cheapest(codes["ancf"], peer["sure"])])
    for code, rows in tables.items():
        yield PEERS[code], ["case", "kind", "error", PEERS[code], "ms", "ancf, at most that error", "ms", "ratio"], rows


def markdown(header, rows):
    head, *lines = ("| " + " | ".join(map(str, line)) + " |" for line in (header, *rows))
    return "\n".join([head, "|" + "---|" * len(header), *lines]) + "\n"


def plain(header, rows):
    widths = [max(map(len, column)) for column in zip(header, *rows)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in (header, *rows)) + "\n"


def main(folder, *options):
    write = markdown if "--markdown" in options else plain
    try:
        tables = [write(*below_bounds(folder)), *(write(*table) for _, *table in beside_fronts(folder))]
    except FileNotFoundError as missing:
        sys.exit(f"ratios.py: {missing}")
    print("\n".join(tables), end="")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
