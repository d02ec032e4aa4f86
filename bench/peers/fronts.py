# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which of many runs count: what stands in the CSV files of speed_against_error and exudyn_cases.py, made safe against luck.

    fronts.py --self-test    exits 1 unless luck, failures and beaten runs are told apart

A run's error may be small by luck, where errors of mesh and time, or of two meshes, happen to cancel. So each run is judged
by its sure error: the largest error of all runs of its family (same case, element, rule and solver) that are at least as
fine in both mesh and step or tolerance. A run that failed has an error of infinity.
"""

import csv
import math
import pathlib
import sys

BOUNDS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


def kind(element):
    """In the plane or in space, with shear or without."""
    return (f"{'cable' if 'cable' in element else 'beam'} "
            f"{'in the plane' if element.startswith('planar') or '2d' in element else 'in space'}")


def run_of(row):
    """A row of a CSV file as a run."""
    error = float(row["error"])
    return {"case": row["case"], "element": row["element"], "rule": row.get("rule", ""), "solver": row["solver"],
            "elements": int(row["elements"]), "setting": float(row.get("step_or_tolerance") or row.get("step") or 0.0),
            "error": error if error >= 0.0 else math.inf, "cpu_ms": float(row["cpu_ms"]),
            "iterations": row.get("iterations", "")}


def family(run):
    return run["case"], run["element"], run["rule"], run["solver"]


def read(paths):
    """The runs of some files with their sure errors; of equal runs the least time and the largest error."""
    best = {}
    for path in paths:
        with open(path, newline="", encoding="utf-8") as file:
            for run in map(run_of, csv.DictReader(file)):
                known = best.setdefault((family(run), run["elements"], run["setting"]), run)
                known["cpu_ms"] = min(known["cpu_ms"], run["cpu_ms"])
                known["error"] = max(known["error"], run["error"])
    return with_sure_errors(best.values())


def with_sure_errors(runs):
    """The runs with the largest error of those of their family that are at least as fine."""
    families = {}
    for run in runs:
        families.setdefault(family(run), []).append(run)
    return [{**run, "sure": max(other["error"] for other in families[family(run)]
                                if other["elements"] >= run["elements"] and other["setting"] <= run["setting"])}
            for run in runs]


def front(runs):
    """The runs that no other is as cheap and as exact as, by time."""
    kept = []
    for run in sorted(runs, key=lambda run: (run["cpu_ms"], run["sure"])):
        if run["sure"] < (kept[-1]["sure"] if kept else math.inf):
            kept.append(run)
    return kept


def cheapest(runs, bound):
    """The cheapest run whose sure error is at most a bound, or None."""
    return min((run for run in runs if run["sure"] <= bound), key=lambda run: run["cpu_ms"], default=None)


def runs_in(folder, code):
    """The runs of a code in a folder of several rounds."""
    return read(sorted(pathlib.Path(folder).glob(f"{code}-*.csv")))


def setting_of(run):
    """The step or the tolerance of a motion; a static run has none worth telling."""
    return f"{run['setting']:g}" if run["case"] in ("pendulum", "link") else ""


def name_of(run):
    """What was run, in one line."""
    words = [run["element"], run["rule"], f"n = {run['elements']}", run["solver"], setting_of(run)]
    return ", ".join(word for word in words if word)


def self_test():
    def run(elements, setting, error, milliseconds, solver="s"):
        return {"case": "c", "element": "e", "rule": "r", "solver": solver, "elements": elements, "setting": setting,
                "error": error, "cpu_ms": milliseconds}

    runs = with_sure_errors([run(1, 1, 1e-4, 1), run(2, 1, 2e-2, 2), run(4, 1, 1e-3, 4), run(4, 0.5, 2e-3, 8),
                             run(8, 1, math.inf, 9), run(8, 0.5, 1e-5, 16), run(1, 1, 5e-2, 1.5, "other")])
    sure = {(run["solver"], run["elements"], run["setting"]): run["sure"] for run in runs}
    failures = []
    if sure["s", 1, 1] != math.inf or sure["s", 4, 0.5] != 2e-3 or sure["s", 8, 0.5] != 1e-5 or sure["other", 1, 1] != 5e-2:
        failures.append(f"sure errors: {sure}")
    if [run["cpu_ms"] for run in front(runs)] != [1.5, 8, 16]:
        failures.append(f"front: {front(runs)}")
    if cheapest(runs, 1e-3)["cpu_ms"] != 16 or cheapest(runs, 1e-6) is not None:
        failures.append("cheapest run below a bound")
    if ({kind(name) for name in ("planar-cable", "cable2d-mixed")} != {"cable in the plane"}
            or kind("planar-quintic") != "beam in the plane" or kind("exact3d") != "beam in space"):
        failures.append("kinds of elements")
    return failures


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-test"]:
        sys.exit(__doc__)
    found = self_test()
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
