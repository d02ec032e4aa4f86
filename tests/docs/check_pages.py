# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the pages: every block of C++ or CMake is a piece of a program or project that the tests build and run, no link
leads nowhere, no code in backticks ends at an apostrophe, where Doxygen takes `it' for a quotation, and below the head
of every table stands a row of dashes, without which it is no table.

    check_pages.py ROOT         exits 1 with one line per finding
    check_pages.py --self-test  exits 1 unless every rule refuses a page that breaks it
"""

import pathlib
import re
import sys

PAGES = ["README.md", "CONTRIBUTING.md", "docs/*.md"]
PROGRAMS = ["examples/tutorial/*.cpp", "examples/downstream/*.cpp",
            "tests/packaging/readme/CMakeLists.txt", "tests/packaging/fetch_content/CMakeLists.txt"]
BLOCK = re.compile(r"^```(?:cpp|cmake)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
SPAN = re.compile(r"(?<!`)(`+)(?!`)((?:(?!\n\n).)+?)(?<!`)\1(?!`)", re.DOTALL)
TABLE = re.compile(r"^\|.*\n(?:\|.*\n?)+", re.MULTILINE)
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
            yield number, f"the block is part of no program: {block[0] if block else 'it is empty'}"


def without_blocks(text):
    return CODE.sub(lambda code: "\n" * code.group().count("\n"), text)


def span_findings(text):
    text = without_blocks(text)
    for match in SPAN.finditer(text):
        ticks, code = len(match.group(1)), match.group(2)
        needed = 3 if "''" in code else 2 if "'" in code else 1
        if ticks < needed:
            yield text[:match.start()].count("\n") + 1, f"code with an apostrophe needs {needed} backticks: {code}"


def link_findings(text, exists):
    text = without_blocks(text)
    for match in LINK.finditer(text):
        target = match.group(1)
        if "://" not in target and not exists(target):
            yield text[:match.start()].count("\n") + 1, f"the link leads nowhere: {target}"


def table_findings(text):
    text = without_blocks(text)
    for match in TABLE.finditer(text):
        head, rule = match.group().splitlines()[:2]
        if not re.fullmatch(r"\|(?: *:?-{3,}:? *\|)+", rule) or rule.count("|") != len(re.findall(r"(?<!\\)\|", head)):
            yield text[:match.start()].count("\n") + 2, f"the row below the head is not one dash row of its columns: {rule}"


def findings(root):
    programs = [lines(path.read_text(encoding="utf-8")) for glob in PROGRAMS for path in sorted(root.glob(glob))]
    blocks = links = spans = tables = 0
    for page in (page for glob in PAGES for page in sorted(root.glob(glob))):
        text = page.read_text(encoding="utf-8")
        blocks += len(BLOCK.findall(text))
        links += len(LINK.findall(text))
        spans += len(SPAN.findall(without_blocks(text)))
        tables += len(TABLE.findall(without_blocks(text)))
        found = [*block_findings(text, programs), *span_findings(text), *table_findings(text),
                 *link_findings(text, lambda name: (page.parent / name).exists())]
        for number, finding in found:
            yield f"{page.relative_to(root)}:{number}: {finding}"
    if blocks < 8 or links < 30 or spans < 500 or tables < 80:
        yield f"only {blocks} blocks, {links} links, {spans} pieces of code and {tables} tables were looked at"


def self_test():
    program = lines("int main() {\n    return 0;\n\n}\n")
    failures = []
    if list(block_findings("```cpp\nreturn 0;\n}\n```\n", [program])):
        failures.append("refused: a piece of a program")
    if not list(block_findings("```cpp\nreturn 1;\n```\n", [program])):
        failures.append("accepted: a block of no program")
    if not list(block_findings("```cmake\nproject(other)\n```\n", [program])):
        failures.append("accepted: a block of no project")
    if list(span_findings("it's `r` and ``p = r0'``, not ```r0\'\'```\n\n```cpp\n'`'\n```\n\na ` alone\n\nanother's ` too")):
        failures.append("refused: code whose apostrophes are kept")
    for wrong in ("`p = r0'`", "`a' = r_y'`", "`it's`", "``r0''``", "`r`: `r0' +\nr1`"):
        if not list(span_findings(wrong)):
            failures.append(f"accepted: {wrong}")
    if list(link_findings("[a](b.md) [c](https://d.invalid)", lambda name: True)):
        failures.append("refused: a good link")
    if list(link_findings("```cpp\n[a](b);\n```\n", lambda name: False)):
        failures.append("refused: code that looks like a link")
    if list(table_findings("| a | b |\n|---|:---:|\n| 1 | |\n\n```\n| no |\n| table |\n```\n")):
        failures.append("refused: a good table")
    for wrong in ("| a | b |\n| --- | fails |\n", "| a | b |\n|---|\n", "| a |\n| 1 |\n"):
        if not list(table_findings(wrong)):
            failures.append(f"accepted: {wrong}")
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
