#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles typical translation units and prints what that costs.

    compile_cost.py [--csv] [--compiler g++] [--flags "-O2"] [--eigen /usr/include/eigen3]
                    [--suitesparse /usr/include/suitesparse] [--rounds 3] [--unit dynamics] [--headers]

Columns: unit, flags, seconds of processor time (the least of all rounds), largest memory in MB, bytes of code and data
in the object file. With --headers, every public header alone instead, once and without code: header, seconds, memory.
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


def compile_unit(command):
    """Returns (seconds of processor time, MB) of a compilation."""
    child = subprocess.Popen(command)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"compile_cost: failed: {shlex.join(map(str, command))}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


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
    arguments = parser.parse_args()
    if arguments.rounds < 1:
        parser.error(f"--rounds must be at least 1, got {arguments.rounds}")
    third_parties = ["-isystem", arguments.eigen, "-isystem", arguments.suitesparse]
    if arguments.headers:
        print("header,seconds,memory_mb" if arguments.csv else f"{'header':46} {'seconds':>8} {'memory, MB':>11}")
        for header in sorted((ROOT / "include").rglob("*.hpp")):
            seconds, memory = compile_unit([arguments.compiler, "-std=c++17", "-fsyntax-only", "-w", "-x", "c++",
                                            f"-I{ROOT}/include", *third_parties, header])
            name = header.relative_to(ROOT / "include")
            line = "{},{:.2f},{:.0f}" if arguments.csv else "{!s:46} {:8.2f} {:11.0f}"
            print(line.format(name, seconds, memory), flush=True)
        return
    print("unit,flags,seconds,memory_mb,object_bytes" if arguments.csv else
          f"{'unit':14} {'flags':22} {'seconds':>8} {'memory, MB':>11} {'object, bytes':>14}")
    for flags in arguments.flags or ["-O2", "-O2 -march=native"]:
        for unit in sorted(UNITS.glob(f"{arguments.unit or '*'}.cpp")):
            with tempfile.TemporaryDirectory() as folder:
                target = pathlib.Path(folder) / "unit.o"
                command = [arguments.compiler, "-std=c++17", *shlex.split(flags), "-DNDEBUG", f"-I{ROOT}/include",
                           *third_parties, "-w", "-c", unit, "-o", target]
                seconds, memory = min(compile_unit(command) for _ in range(arguments.rounds))
                size = subprocess.run(["size", target], capture_output=True, text=True, check=True)
            size = sum(map(int, size.stdout.splitlines()[1].split()[:3]))
            line = "{},{},{:.2f},{:.0f},{}" if arguments.csv else "{:14} {:22} {:8.2f} {:11.0f} {:14}"
            print(line.format(unit.stem, flags, seconds, memory, size), flush=True)


if __name__ == "__main__":
    main()
