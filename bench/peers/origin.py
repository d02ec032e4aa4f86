# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a measurement comes from: commit, machine, compiler, flags and how many other processes ran just before it.

    origin.py BUILD PROGRAM [VERSION]    prints it as JSON for a program of BUILD/bench and, beside it, another code's version
"""

import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
UNKNOWN = "unknown"


def output(*command):
    """What a command prints, nothing where it fails or does not exist."""
    try:
        return subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def machine():
    info = pathlib.Path("/proc/cpuinfo")
    text = info.read_text(encoding="utf-8") if info.is_file() else ""
    model = re.search(r"^model name\s*: (.*)", text, re.MULTILINE)
    numbers = re.search(r"^cpu family\s*: (\d+)\nmodel\s*: (\d+)", text, re.MULTILINE)  # a name may stand for several
    kind = " family {} model {}".format(*numbers.groups()) if numbers else ""
    found = re.search(r"^flags\s*:(.*)", text, re.MULTILINE)
    flags = set(found.group(1).split()) if found else set()
    wide = next((name for name in ("avx512f", "avx2", "avx", "sse2") if name in flags), "registers unknown")
    return f"{model.group(1) if model else UNKNOWN}{kind}, {os.cpu_count()} cores visible, {wide.upper()}"


def cached(build, name):
    """An entry of the build's CMakeCache.txt, empty where there is none."""
    cache = pathlib.Path(build) / "CMakeCache.txt"
    text = cache.read_text(encoding="utf-8") if cache.is_file() else ""
    entry = re.search(rf"^{re.escape(name)}:\w+=(.*)$", text, re.MULTILINE)
    return entry.group(1) if entry else ""


def compiler(build):
    path = cached(build, "CMAKE_CXX_COMPILER")
    return (output(path, "--version").splitlines() or [path or UNKNOWN])[0] if path else UNKNOWN


def compile_commands(build):
    """The build's commands: compile_commands.json, or what ninja tells."""
    path = pathlib.Path(build) / "compile_commands.json"
    text = path.read_text(encoding="utf-8") if path.is_file() else output("ninja", "-C", build, "-t", "compdb")
    text = text[text.find("["):]  # ninja says first which folder it enters
    try:
        return [entry["command"] for entry in json.loads(text)]
    except ValueError:
        return []


def flags(build, program):
    """The flags of a program that make code: optimisation, machine, threads, assertions."""
    for command in compile_commands(build):
        if f"/{program}.dir/" in command and " -c " in command:
            words = shlex.split(command)
            kept = [word for word in words
                    if word == "-DNDEBUG" or word[:2] in ("-m", "-f") and not word.startswith("-fdiagnostics")]
            levels = [word for word in words if word.startswith("-O")]  # the last one counts
            return " ".join([*levels[-1:], *dict.fromkeys(kept)])
    return UNKNOWN


def commit():
    """The commit, marked where what is measured differs from it."""
    short = output("git", "-C", ROOT, "rev-parse", "--short", "HEAD")
    changed = output("git", "-C", ROOT, "status", "--porcelain", "--", "include", "bench", "cmake", "CMakeLists.txt")
    return f"{short or UNKNOWN}{' with changes' if changed else ''}"


def others_running():
    """How many other processes ran in the last second, the mean of twenty looks: what ran earlier does not count."""
    load = pathlib.Path("/proc/loadavg")
    if not load.is_file():
        return os.getloadavg()[0]
    looks = []
    for _ in range(20):
        time.sleep(0.05)
        looks.append(int(load.read_text(encoding="utf-8").split()[3].split("/")[0]) - 1)  # without this one
    return sum(looks) / len(looks)


def origin(build, program=None):
    """What is to be known of a measurement; called before it."""
    return {"commit": commit(), "machine": machine(), "compiler": compiler(build),
            "flags": flags(build, program) if program else "in the table", "load": f"{others_running():.1f}"}


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    print(json.dumps({**origin(*sys.argv[1:3]), **({"other": sys.argv[3]} if len(sys.argv) == 4 else {})}, indent=1))
