# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares docs/verification.md with what the example programs compute now.

    check_verification.py FOLDER    exits 1 with one pair of lines per line that is stale
"""

import pathlib
import subprocess
import sys

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "verification"

if __name__ == "__main__":
    build = pathlib.Path(sys.argv[1]).resolve().parent
    sys.exit(subprocess.run([sys.executable, SCRIPT, build, "--check"], check=False).returncode)
