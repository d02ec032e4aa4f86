#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles typical translation units and prints what that costs.

    compile_cost.py [--csv] [--compiler g++] [--flags "-O2"] [--eigen /usr/include/eigen3]
                    [--suitesparse /usr/include/suitesparse] [--rounds 3] [--unit dynamics] [--headers]
    compile_cost.py --check      exits 1 where a unit costs more times element.cpp than its limit, plus a fifth, in all rounds

Each unit is compiled header-only and, but for the element alone, as a program of the compiled library. Columns: unit,
form, flags, seconds of processor time (the least of all rounds, which take turns), seconds divided by those of
element.cpp, largest memory in MB, bytes of code and data in the object file. With --headers, every public header alone
instead, once and without code: header, seconds, memory; but for those of PETSc, which need the folders of its MPI.
"""

import argparse
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

UNITS = pathlib.Path(__file__).resolve().parent
ROOT = UNITS.parent.parent
FORMS = {"header-only": [], "compiled": ["-DANCF_COMPILED"]}
# Times the seconds of element.cpp, header-only; by --check. Those of the header-only form hold what was reached; 3 is the aim.
LIMITS = {("statics", "header-only"): 5.1, ("statics", "compiled"): 1.5,
          ("dynamics", "header-only"): 5.1, ("dynamics", "compiled"): 1.5}
MARGIN = 1.2


def compile_unit(command):
    """Returns (seconds of processor time, MB) of a compilation."""
    child = subprocess.Popen(command)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"compile_cost: failed: {shlex.join(map(str, command))}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def object_bytes(target):
    """Returns the bytes of code and data in an object file."""
    run = subprocess.run(["size", target], capture_output=True, text=True, check=True)
    return sum(map(int, run.stdout.splitlines()[1].split()[:3]))


def above_limits(best):
    """Returns a line for each unit that costs more than its limit and the margin."""
    element = best["element", "header-only"][0]
    return [f"{unit}, {form}: {seconds / element:.2f} times element.cpp, limit {LIMITS[unit, form]} and a fifth"
            for (unit, form), (seconds, _, _) in best.items()
            if (unit, form) in LIMITS and seconds > MARGIN * LIMITS[unit, form] * element]


def measure(wanted, command, rounds, check):
    """Returns (least seconds, MB, bytes of the object) by (unit, form); the units take turns.

    To check them, element.cpp is compiled between the others, and a further round only where one is above its limit.
    """
    best = {}
    if check:
        element, *others = sorted(wanted, key=lambda one: one[0].stem != "element")
        wanted = [element, *(one for other in others for one in (other, element))]
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "unit.o"
        for _ in range(rounds):
            for unit, form in wanted:
                seconds, memory = compile_unit([*command, *FORMS[form], "-c", unit, "-o", target])
                now = seconds, memory, object_bytes(target)
                best[unit.stem, form] = min(best.get((unit.stem, form), now), now)
            if check and not above_limits(best):
                break
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--csv", action="store_true", help="comma-separated values")
    parser.add_argument("--compiler", default=os.environ.get("CXX", "g++"))
    parser.add_argument("--flags", action="append", help="flags of one column; may be repeated")
    parser.add_argument("--eigen", default="/usr/include/eigen3", help="folder of Eigen's headers")
    parser.add_argument("--suitesparse", default="/usr/include/suitesparse", help="folder of SuiteSparse's headers")
    parser.add_argument("--rounds", type=int, default=3, help="how often each unit is compiled")
    parser.add_argument("--unit", choices=sorted(unit.stem for unit in UNITS.glob("*.cpp")), help="this unit alone")
    parser.add_argument("--headers", action="store_true", help="every public header alone")
    parser.add_argument("--check", action="store_true", help="compare with the limits")
    arguments = parser.parse_args()
    if arguments.rounds < 1:
        parser.error(f"--rounds must be at least 1, got {arguments.rounds}")
    third_parties = ["-isystem", arguments.eigen, "-isystem", arguments.suitesparse]
    if arguments.headers:
        print("header,seconds,memory_mb" if arguments.csv else f"{'header':46} {'seconds':>8} {'memory, MB':>11}")
        for header in sorted((ROOT / "include").rglob("*.hpp")):
            if header.parent.name == "petsc":
                continue
            seconds, memory = compile_unit([arguments.compiler, "-std=c++17", "-fsyntax-only", "-w", "-x", "c++",
                                            f"-I{ROOT}/include", *third_parties, header])
            name = header.relative_to(ROOT / "include")
            line = "{},{:.2f},{:.0f}" if arguments.csv else "{!s:46} {:8.2f} {:11.0f}"
            print(line.format(name, seconds, memory), flush=True)
        return
    flags_given = ["-O2"] if arguments.check else arguments.flags or ["-O2", "-O2 -march=native"]
    print("unit,form,flags,seconds,times_element,memory_mb,object_bytes" if arguments.csv else
          f"{'unit':14} {'form':12} {'flags':18} {'seconds':>8} {'times element':>14} {'memory, MB':>11} {'object, bytes':>14}")
    failures = []
    for flags in flags_given:
        wanted = [(unit, form) for unit in sorted(UNITS.glob("*.cpp")) for form in FORMS
                  if unit.stem == "element" and form == "header-only"
                  or unit.stem != "element" and arguments.unit in (None, unit.stem)
                  and (not arguments.check or (unit.stem, form) in LIMITS)]
        best = measure(wanted, [arguments.compiler, "-std=c++17", *shlex.split(flags), "-DNDEBUG", f"-I{ROOT}/include",
                                *third_parties, "-w"], arguments.rounds, arguments.check)
        element = best["element", "header-only"][0]
        for (unit, form), (seconds, memory, size) in best.items():
            line = "{},{},{},{:.2f},{:.2f},{:.0f},{}" if arguments.csv else "{:14} {:12} {:18} {:8.2f} {:14.2f} {:11.0f} {:14}"
            print(line.format(unit, form, flags, seconds, seconds / element, memory, size), flush=True)
        if arguments.check:
            failures += above_limits(best)
    print("\n".join(failures), end="\n" if failures else "")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
