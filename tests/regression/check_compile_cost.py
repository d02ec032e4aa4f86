# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the preprocessed lines of every header, with all it includes, and compares them with the recorded ones.

    check_compile_cost.py COMPILER ID ROOT [INCLUDE...]           exits 1 where a header has 10 % more than recorded,
                                                                  77 (skipped) without a record for ID
    check_compile_cost.py COMPILER ID ROOT [INCLUDE...] --record  writes the record
    check_compile_cost.py --self-test                             exits 1 unless growth is refused

ID names compiler and third parties, such as GNU-12 Eigen-3.4.0: their headers are counted too. Components whose third party
is missing are left out.
"""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

RECORD = pathlib.Path(__file__).resolve().parent / "preprocessed_lines.json"
UMBRELLA = "ancf/ancf.hpp"  # the longest: it includes all of the core
LIMIT = 1.10
SKIPPED = 77


def lines_of(compiler, root, includes, header):
    """Lines after preprocessing, None where the preprocessor fails."""
    run = subprocess.run(
        [compiler, "-std=c++17", "-E", "-P", "-x", "c++", f"-I{root}/include",
         *(argument for folder in includes for argument in ("-isystem", folder)), "-"],
        input=f"#include <{header}>\n", capture_output=True, text=True, check=False)
    return run.stdout.count("\n") if run.returncode == 0 else None


def count(compiler, root, includes):
    base = pathlib.Path(root) / "include"
    headers = [path.relative_to(base).as_posix() for path in sorted(base.rglob("*.hpp"))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip(headers, pool.map(lambda name: lines_of(compiler, root, includes, name), headers)))
    for name, lines in counts.items():
        if lines is None and name.split("/")[1] not in ("suitesparse", "sundials"):
            sys.exit(f"{name}: the preprocessor failed")
    return {name: lines for name, lines in counts.items() if lines is not None}


def findings(counts, record):
    """One line per header above its limit; a new one has the umbrella's."""
    for name, lines in counts.items():
        most = record.get(name, record[UMBRELLA])
        if lines > LIMIT * most:
            yield f"{name}: {lines} lines, recorded {most}, limit {LIMIT:.2f} times that"


def self_test():
    record = {"a.hpp": 1000, UMBRELLA: 2000}
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
    records = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.is_file() else {}
    if "--record" in arguments:
        records[identity] = count(compiler, root, includes)
        RECORD.write_text(json.dumps(records, indent=4) + "\n", encoding="utf-8")
        return 0
    if identity not in records:
        print(f"skipped: no record for {identity}; there are {', '.join(records)}")
        return SKIPPED
    counts = count(compiler, root, includes)
    lines = list(findings(counts, records[identity]))
    print("\n".join(lines))
    print(f"{len(counts)} headers, {len(lines)} above their limit; ancf.hpp: {counts[UMBRELLA]} lines")
    return 1 if lines or not counts else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
