# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts by valgrind and objdump which instructions an evaluation of the cross-section beam executes, by class.

    instruction_mix.py build/release/bench/instruction_mix

The program must not have instructions that valgrind does not know, such as those of AVX-512. Bounds are shares of the peak:
what would be reached if a core did nothing but start two products, fused or not, two loads or one store a cycle, and every
other instruction cost nothing.
"""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile

CLASSES = [("fused", r"vfn?m(add|sub)"), ("products", r"v?mul"), ("sums", r"v?(add|sub)[ps]"), ("divisions", r"v?div"),
           ("roots", r"v?sqrt"), ("moves", r"v?mov|vbroadcast")]
COLUMNS = ["all", "fused", "products", "sums", "divisions", "roots", "loads", "stores", "scalar"]


def instructions(program):
    """Address, mnemonic and operands of every instruction."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], capture_output=True, text=True, check=True).stdout
    return {int(found[1], 16): (found[2], found[3])
            for found in re.finditer(r"^\s+([0-9a-f]+):\t(\S+)\s*(.*)$", text, re.MULTILINE)}


def executed(program, function):
    """How often each address was executed from entering a function to leaving it."""
    counts, behind_call = collections.Counter(), False
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "out")
        subprocess.run(["valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-pos=no", f"--toggle-collect={function}",
                        f"--callgrind-out-file={out}", program], capture_output=True, check=True)
        for line in out.read_text().splitlines():
            found = re.match(r"0x([0-9a-f]+) \S+ (\d+)$", line)
            if found and not behind_call:  # what a call costs in all stands in its own lines
                counts[int(found[1], 16)] += int(found[2])
            behind_call = line.startswith("calls=")
    return counts


def kinds(name, operands):
    """The classes of one instruction."""
    yield "all"
    if not re.search("[xyz]mm", operands):
        yield "scalar"
    kind = next((label for label, pattern in CLASSES if re.match(pattern, name)), "moves")
    if kind != "moves":
        yield kind
    if "(" in operands and not name.startswith("lea"):
        yield "stores" if kind == "moves" and operands.rstrip().endswith(")") else "loads"


def main(program):
    code = instructions(program)
    print(f"{'':18}" + "".join(f"{column:>10}" for column in COLUMNS) + "   bounds: products, loads, stores")
    for function in ("measured_force", "measured_tangent"):
        counts = executed(program, function)
        # where a position-independent program was loaded: the shift by which most addresses are known
        shift = max((0, 0x108000, 0x400000), key=lambda by: sum(address - by in code for address in counts))
        total = collections.Counter()
        for address, times in counts.items():
            for kind in kinds(*code[address - shift]) if address - shift in code else ():
                total[kind] += times
        operations = 2 * total["fused"] + sum(total[kind] for kind in ("products", "sums", "divisions", "roots"))
        slots = [(total["fused"] + total["products"]) / 2, total["loads"] / 2, total["stores"]]
        print(f"{function:18}" + "".join(f"{total[column]:10}" for column in COLUMNS) + "   "
              + ", ".join(f"{operations / 4 / cycles:.0%}" for cycles in slots))


if __name__ == "__main__":
    main(sys.argv[1])
