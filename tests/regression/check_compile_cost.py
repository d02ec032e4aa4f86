# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts what there is to compile and what comes out, and compares both with the recorded counts.

    check_compile_cost.py COMPILER ID ROOT [INCLUDE...]           exits 1 where a count is 10 % above its record,
                                                                  77 (skipped) without any record for ID
    check_compile_cost.py COMPILER ID ROOT [INCLUDE...] --record  writes the records
    check_compile_cost.py --self-test                             exits 1 unless growth is refused

preprocessed_lines.json: lines of every header, with all it includes. object_bytes.json: code and data at -O2 of the units of
bench/compile_cost that have a limit, header-only and with the compiled library. ID names compiler and third parties, such as
GNU-12 Eigen-3.4.0: their headers are counted too. What needs a component whose third party is missing is left out.
"""

import concurrent.futures
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.append(str(HERE.parent.parent / "bench" / "compile_cost"))
import compile_cost  # noqa: E402

LIMIT = 1.10
SKIPPED = 77
NEEDS_COMPONENT = ("ancf/petsc/", "ancf/suitesparse/", "ancf/sundials/", "dynamics.cpp")


def lines_of(command, header):
    """Lines of a header after preprocessing, None where the preprocessor fails."""
    run = subprocess.run([*command, "-E", "-P", "-x", "c++", "-"], input=f"#include <{header}>\n",
                         capture_output=True, text=True, check=False)
    return run.stdout.count("\n") if run.returncode == 0 else None


def bytes_of(command, unit, form):
    """Bytes of a unit's object, None where the compiler fails."""
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "unit.o"
        run = subprocess.run([*command, "-O2", "-DNDEBUG", "-w", *compile_cost.FORMS[form], "-c", unit, "-o", target],
                             capture_output=True, check=False)
        return compile_cost.object_bytes(target) if run.returncode == 0 else None


def count(command, tasks):
    """Counts by name of task, which is a function of the command and its further arguments."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip(tasks, pool.map(lambda task: task[0](command, *task[1:]), tasks.values())))
    for name, value in counts.items():
        if value is None and not name.startswith(NEEDS_COMPONENT):
            sys.exit(f"{name}: the compiler failed")
    return {name: value for name, value in counts.items() if value is not None}


def findings(counts, record):
    """One line per count above its limit; a new one has that of the largest."""
    for name, value in counts.items():
        most = record.get(name, max(record.values()))
        if value > LIMIT * most:
            yield f"{name}: {value}, recorded {most}, limit {LIMIT:.2f} times that"


def self_test():
    record = {"a.hpp": 1000, "ancf.hpp": 2000}
    return [text for text, good in [
        ("accepted 11 % more", list(findings({"a.hpp": 1110}, record))),
        ("accepted a new header longer than the umbrella", list(findings({"b.hpp": 2300}, record))),
        ("refused 9 % more", not list(findings({"a.hpp": 1090}, record))),
    ] if not good]


def main(arguments):
    if arguments == ["--self-test"]:
        failures = self_test()
        print("\n".join(failures))
        return 1 if failures else 0
    compiler, identity, root, *includes = [text for text in arguments if text != "--record"]
    base = pathlib.Path(root) / "include"
    command = [compiler, "-std=c++17", f"-I{base}", *(word for folder in includes for word in ("-isystem", folder))]
    headers = [path.relative_to(base).as_posix() for path in sorted(base.rglob("*.hpp"))]
    lines = {header: (lines_of, header) for header in headers}
    objects = {f"{unit}.cpp, {form}": (bytes_of, compile_cost.UNITS / f"{unit}.cpp", form)
               for unit, form in sorted(compile_cost.LIMITS)}
    results = []
    for measure, name, tasks in [("preprocessed_lines", identity, lines),
                                 ("object_bytes", f"{identity} {platform.machine()}", objects)]:
        file = HERE / f"{measure}.json"
        records = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
        if "--record" in arguments:
            records[name] = count(command, tasks)
            file.write_text(json.dumps(records, indent=4) + "\n", encoding="utf-8")
            results.append(0)
        elif name in records:
            counts = count(command, tasks)
            above = list(findings(counts, records[name]))
            print(*above, f"{measure}: {len(counts)} counts, {len(above)} above their limit", sep="\n")
            results.append(1 if above or not counts else 0)
        else:
            print(f"{measure}: skipped: no record for {name}; there are {', '.join(records)}")
    return max(results, default=SKIPPED)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
