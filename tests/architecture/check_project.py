# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that one version stands everywhere, that no file carries open ends and that code keeps to 100 columns.

    check_project.py ROOT         exits 1 with one line per finding
    check_project.py --self-test  exits 1 unless every rule refuses a tree that breaks it
"""

import pathlib
import re
import sys
import tempfile

VERSIONS = {  # file: where its version stands; the first is the one the others must equal
    "CMakeLists.txt": r"project\(ancf\s+VERSION ([0-9.]+)",
    "include/ancf/version.hpp": r'version = "([^"]*)"',
    "CITATION.cff": r"^version: (\S+)",
    "CHANGELOG.md": r"^## \[?([0-9][0-9.]*)",
}
FOLDERS = ["include", "tests", "examples", "bench", "docs", "cmake", "scripts"]
SUFFIXES = {".hpp", ".ipp", ".cpp", ".py", ".md", ".txt", ".cmake", ".in", ".gp", ".sh", ""}
CODE = {".hpp", ".ipp", ".cpp"}
COLUMNS = 100
OPEN_ENDS = re.compile(r"\b(TO" + "DO|FIX" + "ME|XX" + "X)\\b")


def version_findings(root):
    expected = None
    for name, pattern in VERSIONS.items():
        path = root / name
        match = path.is_file() and re.search(pattern, path.read_text(encoding="utf-8"), re.MULTILINE)
        if not match:
            yield f"{name}: no version found"
        elif expected is None:
            expected = match.group(1)
        elif match.group(1) != expected:
            yield f"{name}: version {match.group(1)}, but CMakeLists.txt has {expected}"


def text_findings(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if not path.is_file() or path.suffix not in SUFFIXES or "__pycache__" in path.parts:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if OPEN_ENDS.search(line):
                    yield f"{path.relative_to(root)}:{number}: an open end: {line.strip()}"
                if path.suffix in CODE and len(line) > COLUMNS:
                    yield f"{path.relative_to(root)}:{number}: {len(line)} columns"


def findings(root):
    yield from version_findings(root)
    yield from text_findings(root)


def self_test():
    right = {
        "CMakeLists.txt": "project(ancf\n    VERSION 1.2.3\n",
        "include/ancf/version.hpp": 'version = "1.2.3";',
        "CITATION.cff": "cff-version: 1.2.0\nversion: 1.2.3\n",
        "CHANGELOG.md": "# Changelog\n\n## 1.2.3\n\n## 1.0.0\n",
    }
    wrong = [
        ({"include/ancf/version.hpp": 'version = "1.2.4";'}, "version.hpp: version 1.2.4"),
        ({"CITATION.cff": "version: 2.0.0\n"}, "CITATION.cff: version 2.0.0"),
        ({"CHANGELOG.md": "## 1.2.2\n"}, "CHANGELOG.md: version 1.2.2"),
        ({"CMakeLists.txt": "project(other)\n"}, "CMakeLists.txt: no version"),
        ({"tests/wide.cpp": "//" + 99 * "x"}, "tests/wide.cpp:1: 101 columns"),
        ({"docs/page.md": "first\nTO" + "DO: second\n"}, "docs/page.md:2: an open end"),
    ]
    failures = [f"refused: {line}" for line in findings_of(right)]
    for change, reason in wrong:
        if not any(reason in line for line in findings_of({**right, **change})):
            failures.append(f"accepted: {reason}")
    return failures


def findings_of(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return list(findings(root))


def main(argument):
    lines = self_test() if argument == "--self-test" else list(findings(pathlib.Path(argument)))
    for line in lines:
        print(line)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
