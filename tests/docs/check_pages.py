# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the pages: every C++ block is a piece of a program that is compiled and run, and no link leads nowhere.

    check_pages.py ROOT         exits 1 with one line per finding
    check_pages.py --self-test  exits 1 unless every rule refuses a page that breaks it
"""

import pathlib
import re
import sys

PAGES = ["README.md", "CONTRIBUTING.md", "docs/*.md"]
PROGRAMS = ["examples/tutorial/*.cpp", "examples/downstream/*.cpp", "tests/support/instances/*.hpp"]
BLOCK = re.compile(r"^```cpp\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")


def lines(text):
    """The text's lines without indentation and without those that are empty."""
    return [line.strip() for line in text.splitlines() if line.strip()]


def contains(program, block):
    return any(program[k:k + len(block)] == block for k in range(len(program) - len(block) + 1))


def block_findings(text, programs):
    for match in BLOCK.finditer(text):
        block = lines(match.group(1))
        if not any(contains(program, block) for program in programs):
            number = text[:match.start()].count("\n") + 1
            yield number, f"the C++ block is part of no program: {block[0] if block else 'it is empty'}"


def link_findings(text, exists):
    text = CODE.sub(lambda code: "\n" * code.group().count("\n"), text)
    for match in LINK.finditer(text):
        target = match.group(1)
        if "://" not in target and not exists(target):
            yield text[:match.start()].count("\n") + 1, f"the link leads nowhere: {target}"


def findings(root):
    programs = [lines(path.read_text(encoding="utf-8")) for glob in PROGRAMS for path in sorted(root.glob(glob))]
    blocks = links = 0
    for page in (page for glob in PAGES for page in sorted(root.glob(glob))):
        text = page.read_text(encoding="utf-8")
        blocks += len(BLOCK.findall(text))
        links += len(LINK.findall(text))
        found = [*block_findings(text, programs), *link_findings(text, lambda name: (page.parent / name).exists())]
        for number, finding in found:
            yield f"{page.relative_to(root)}:{number}: {finding}"
    if blocks < 8 or links < 30:
        yield f"only {blocks} C++ blocks and {links} links were looked at"


def self_test():
    program = lines("int main() {\n    return 0;\n\n}\n")
    failures = []
    if list(block_findings("```cpp\nreturn 0;\n}\n```\n", [program])):
        failures.append("refused: a piece of a program")
    if not list(block_findings("```cpp\nreturn 1;\n```\n", [program])):
        failures.append("accepted: a block of no program")
    if list(link_findings("[a](b.md) [c](https://d.invalid)", lambda name: True)):
        failures.append("refused: a good link")
    if list(link_findings("```cpp\n[a](b);\n```\n", lambda name: False)):
        failures.append("refused: code that looks like a link")
    if not list(link_findings("[a](b.md)", lambda name: False)):
        failures.append("accepted: a link to nowhere")
    return failures


def main(argument):
    found = self_test() if argument == "--self-test" else list(findings(pathlib.Path(argument).resolve()))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
