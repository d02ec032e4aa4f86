#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solves random cantilevers in one load step and in forty, and counts those that end elsewhere, with a note on stderr or without.

Where the forty steps themselves end in an unstable state, or a crushed one, they say nothing of the one.

    branches.py [--program build/release/examples/cantilever] [--count 1000] [--seed 1]

Exits 1 where a tip is more than 1e-5 of the length elsewhere without a note, or where a run crashes or does not end.
"""

import argparse
import collections
import pathlib
import random
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
NOTES = ("indefinite", "unstable", "softens", "turns by")


def draw(source):
    """Options of a random cantilever."""
    height = repr(10.0 ** source.uniform(-3.0, -0.7))
    options = ["--length", "1", "--width", height, "--height", height,
               "--load-factor", repr(10.0 ** source.uniform(-0.3, 2.0)),
               "--rule", source.choice(["gauss3", "paper", "lobatto3", "mixed", "gauss5"]),
               "--elements", str(source.choice([1, 2, 3, 4, 5, 6, 8, 12, 16])),
               "--element", source.choice(["cross-section", "cross-section", "cross-section-2d"])]
    return options + (["--newton", "mixed"] if source.random() < 0.3 else [])


def solve(program, options):
    """The tip and the notes, nothing where the run did not converge."""
    run = subprocess.run([program, *options], capture_output=True, text=True, timeout=60, check=False)
    if run.returncode not in (0, 1):
        sys.exit(f"branches: exit {run.returncode} of {' '.join(options)}\n{run.stderr}")
    row = run.stdout.splitlines()[-1].split()
    if row[3] != "converged":
        return None
    return [float(value) for value in row[4:6]], [note for note in NOTES if note in run.stderr]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=ROOT / "build" / "release" / "examples" / "cantilever")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    source = random.Random(arguments.seed)
    counts, silent = collections.Counter(), []
    for _ in range(arguments.count):
        options = draw(source)
        once, slowly = solve(arguments.program, options), solve(arguments.program, [*options, "--steps", "40"])
        if once is None or slowly is None:
            counts["not converged by one step or by forty"] += 1
            continue
        (tip, notes), (other, doubts) = once, slowly
        if "unstable" in doubts or "softens" in doubts:
            counts["forty steps end unstable or crushed"] += 1
            continue
        elsewhere = max(abs(a - b) for a, b in zip(tip, other)) > 1e-5
        told = f"told by {' and '.join(notes)}" if notes else "not told"
        counts[f"{'elsewhere' if elsewhere else 'at the same place'}, {told}"] += 1
        if elsewhere and not notes:
            silent.append(" ".join(options))
    print(sum(counts.values()), "cantilevers")
    for what, count in sorted(counts.items(), key=lambda item: -item[1]):
        print(f"{count:8}  {what}")
    for options in silent:
        print(options)
    return 1 if silent else 0


if __name__ == "__main__":
    sys.exit(main())
