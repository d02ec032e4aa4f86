#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of the component petsc with PETSc's own bookkeeping: no object and no memory is left at the end.

    check_leaks.py TEST_PROGRAM LAUNCHER [ARGUMENT...]

Without the test whose options PETSc refuses: there PETSc itself forgets a few names, 48 bytes in 3.18. The same run with a solver that is never destroyed has to show: else the bookkeeping is not on.
"""

import subprocess
import sys


def left_over(program, launcher, tests):
    """Returns what PETSc says was never freed."""
    command = [*launcher, program, *tests, "--", "-malloc_debug", "-malloc_dump", "-objects_dump"]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)} ended with {run.returncode}:\n{run.stdout[-4000:]}")
    return [line for line in run.stdout.splitlines() if "never freed" in line or " bytes " in line or line.startswith("[0] ")]


def main():
    program, launcher = sys.argv[1], sys.argv[2:]
    found = left_over(program, launcher, ["[petsc]~[refused]"])
    if found:
        sys.exit("left at the end:\n" + "\n".join(found[:40]))
    planted = left_over(program, launcher, ["planted leak"])
    if not any("KSP" in line for line in planted):
        sys.exit("a solver that is never destroyed went unnoticed")
    print(f"nothing is left; a planted leak shows in {len(planted)} lines")


if __name__ == "__main__":
    main()
