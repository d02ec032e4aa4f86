# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts by gdb which instructions an evaluation of the cross-section beam executes, by class.

    gdb -batch -nx -x bench/instruction_mix.py build/release/bench/instruction_mix    (Debian: apt install gdb)

The processor itself takes the steps, so any instructions that it knows are counted; it takes ten seconds. Bounds are
shares of the peak: what would be reached if a core did nothing but start two products, fused or not, two loads or one
store a cycle, and every other instruction cost nothing.
"""

import collections
import re

import gdb

CLASSES = [("fused", r"vfn?m(add|sub)"), ("products", r"v?mul"), ("sums", r"v?(add|sub)[ps]"), ("divisions", r"v?div"),
           ("roots", r"v?sqrt"), ("moves", r"v?mov|vbroadcast")]
STATIONS = 4  # of the rule
COLUMNS = ["all", "fused", "products", "sums", "divisions", "roots", "loads", "stores", "scalar"]


def executed():
    """Text, bytes and number of executions of each instruction from here to the end of the function."""
    frame = gdb.newest_frame()
    end, architecture = frame.older().pc(), frame.architecture()
    codes, counts, before = {}, collections.Counter(), None
    while (at := int(gdb.parse_and_eval("$pc"))) != end:
        if at not in codes:
            codes[at] = architecture.disassemble(at)[0]
        counts[at] += at != before  # a repeated store is one instruction
        before = at
        gdb.execute("stepi", to_string=True)
    return [(codes[at]["asm"], codes[at]["length"], times) for at, times in counts.items()]


def kinds(text):
    """The classes of one instruction, given as gdb writes it."""
    name, _, operands = text.partition(" ")
    yield "all"
    if not re.search("[xyz]mm", operands):
        yield "scalar"
    kind = next((label for label, pattern in CLASSES if re.match(pattern, name)), "moves")
    if kind != "moves":
        yield kind
    if "(" in operands and not name.startswith("lea"):
        yield "stores" if kind == "moves" and operands.rstrip().endswith(")") else "loads"


def main():
    functions = ("measured_force", "measured_tangent")
    for function in functions:
        gdb.execute(f"break *{function}", to_string=True)
    gdb.execute("set suppress-cli-notifications on")
    gdb.execute("run", to_string=True)
    print(f"{'':18}" + "".join(f"{column:>10}" for column in COLUMNS) + "   bounds: products, loads, stores")
    for function in functions:
        total = collections.Counter()
        size, repeated = 0, 0
        for text, length, times in executed():
            size += length
            repeated += length if times >= STATIONS else 0
            for kind in kinds(text):
                total[kind] += times
        operations = 2 * total["fused"] + sum(total[kind] for kind in ("products", "sums", "divisions", "roots"))
        slots = [(total["fused"] + total["products"]) / 2, total["loads"] / 2, total["stores"]]
        print(f"{function:18}" + "".join(f"{total[column]:10}" for column in COLUMNS) + "   "
              + ", ".join(f"{operations / 4 / cycles:.0%}" for cycles in slots) + f"; {size / 1000:.0f} KB of code, {repeated / 1000:.0f} at each station")
        gdb.execute("continue", to_string=True)


main()
