# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that a program of one kind of element holds the code of no other kind.

    check_symbols.py NM PROGRAM WANTED FORBIDDEN...    exits 1 with the symbols that should not be there

The program must hold symbols named WANTED, else there is nothing to look at.
"""

import subprocess
import sys


def main(nm, program, wanted, *forbidden):
    listing = subprocess.run([nm, "-C", program], text=True, capture_output=True, check=True).stdout.splitlines()
    present = sum(wanted in line for line in listing)
    findings = [line for line in listing if any(word in line for word in forbidden)]
    for line in findings:
        print(line)
    print(f"{len(listing)} symbols, {present} of {wanted}, {len(findings)} findings")
    sys.exit(1 if findings or present == 0 else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
