# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the example programs for the checks beside this file."""

import os
import pathlib
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

TIME_LIMIT = int(os.environ.get("ANCF_TIME_LIMIT", "60"))  # seconds for one run


class Run:
    """What one command line did: code, output and errors; a crash has a negative code."""

    def __init__(self, folder, program, arguments, text=""):
        self.command = shlex.join([program, *arguments])
        try:
            done = subprocess.run([pathlib.Path(folder) / program, *arguments], input=text, text=True,
                                  capture_output=True, timeout=TIME_LIMIT, check=False)
            self.code, self.output, self.errors = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            self.code, self.output, self.errors = None, "", f"no end after {TIME_LIMIT} s"

    def rows(self):
        """The rows of its CSV output, as dictionaries."""
        header, *lines = self.output.splitlines()
        return [dict(zip(header.split(","), line.split(","))) for line in lines]

    def header(self):
        return self.output.split("\n", 1)[0]


def run_all(folder, commands):
    """Runs (program, arguments, stdin) side by side, in order of the list."""
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        return list(pool.map(lambda command: Run(folder, *command), commands))


def report(findings, count, what):
    """Prints the findings and ends the program."""
    for finding in findings:
        print(finding)
    print(f"{count} {what}, {len(findings)} findings")
    sys.exit(1 if findings or count == 0 else 0)
