# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts instructions by valgrind and compares them with the recorded ones.

    check_instructions.py PROGRAM COMPILER            exits 1 where a count is 1 % above its record, 77 (skipped)
                                                      without valgrind or without a record for this compiler
    check_instructions.py PROGRAM COMPILER --record   writes the record
    check_instructions.py --self-test                 exits 1 unless a count above its limit is refused

COMPILER is a name and a major version, such as GNU-12: other compilers make other instructions. Counts repeat to the
last one.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).resolve().parent / "instructions.json"
FUNCTIONS = {"force and tangent of one element": "measured_evaluation",
             "Newton iteration of 100 elements": "measured_iteration"}
LIMIT = 1.01
SKIPPED = 77


def count(valgrind, program, function):
    """Instructions from entering a function to leaving it."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [valgrind, "--tool=callgrind", f"--toggle-collect={function}",
             f"--callgrind-out-file={folder}/out", program],
            capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found or int(found.group(1)) == 0:
        sys.exit(f"valgrind counted nothing in {function}:\n{run.stderr}")
    return int(found.group(1))


def findings(counts, record):
    """One line per count that is above its limit, or that has no record."""
    for name, value in counts.items():
        if name not in record:
            yield f"{name}: no record"
        elif value > LIMIT * record[name]:
            yield f"{name}: {value} instructions, recorded {record[name]}, limit {LIMIT:.2f} times that"


def self_test():
    record = {"a": 1000}
    return [text for text, good in [
        ("accepted 1.1 % more", list(findings({"a": 1011}, record))),
        ("accepted a count without a record", list(findings({"b": 1}, record))),
        ("refused 0.9 % more", not list(findings({"a": 1009}, record))),
        ("refused fewer", not list(findings({"a": 10}, record))),
    ] if not good]


def main(arguments):
    if arguments == ["--self-test"]:
        failures = self_test()
        print("\n".join(failures))
        return 1 if failures else 0
    program, compiler, *options = arguments
    valgrind = shutil.which("valgrind")
    if not valgrind:
        print("skipped: valgrind was not found (Debian, Ubuntu: apt install valgrind)")
        return SKIPPED
    counts = {name: count(valgrind, program, function) for name, function in FUNCTIONS.items()}
    records = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.is_file() else {}
    for name, value in counts.items():
        print(f"{name}: {value} instructions, recorded {records.get(compiler, {}).get(name, 'none')}")
    if options == ["--record"]:
        records[compiler] = counts
        RECORD.write_text(json.dumps(records, indent=4) + "\n", encoding="utf-8")
        return 0
    if compiler not in records:
        print(f"skipped: no record for {compiler}; there are {', '.join(records)}")
        return SKIPPED
    lines = list(findings(counts, records[compiler]))
    print("\n".join(lines))
    return 1 if lines else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
