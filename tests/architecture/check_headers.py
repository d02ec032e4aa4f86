# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the headers: layers include in one direction only, and every file opens as the house does.

Files of definitions, *.ipp, keep to the rules of the header of that name, which includes them at its end.

    check_headers.py ROOT         exits 1 with one line per finding
    check_headers.py --self-test  exits 1 unless every rule refuses a tree that breaks it
"""

import pathlib
import re
import sys
import tempfile

LAYERS = ["section", "element", "model", "assembly", "solver", "dynamics", "output"]
COMPONENTS = ["suitesparse", "sundials", "petsc"]  # beside the layers: may include all of them, never each other
COMMON = ["algebra.hpp", "compiled.hpp", "compiler.hpp", "constants.hpp", "error.hpp", "list.hpp", "types.hpp", "vector_argument.hpp",
          "version.hpp"]
UMBRELLA = "ancf.hpp"
MOST_PUBLIC = 112
ABOVE = [UMBRELLA]  # include any layer, no header includes them
DEFINITIONS = re.compile(r"#if !defined\(ANCF_COMPILED\)\n#include <ancf/([a-z_0-9/]+\.ipp)>.*\n#endif\n\Z")
LICENCE = ("// SPDX-FileCopyrightText: 2026 The ancf authors\n"
           "// SPDX-License-Identifier: BSD-3-Clause\n")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def may_include(includer, included):
    """Whether the header `includer` may include `included`, both relative to include/ancf."""
    includer, included = (name.replace(".ipp", ".hpp") for name in (includer, included))
    source, target = includer.split("/")[0], included.split("/")[0]
    if included in ABOVE:
        return False
    if includer in ABOVE:
        return target not in COMPONENTS
    if included in COMMON:
        return True
    if includer in COMMON:
        return False
    if source in COMPONENTS:
        return target == source or target in LAYERS
    return target in LAYERS and LAYERS.index(target) <= LAYERS.index(source)


def place_findings(name):
    folder = name.split("/")[0]
    if "/" not in name and name.replace(".ipp", ".hpp") not in COMMON + ABOVE:
        yield "stands in no layer"
    if "/" in name and folder not in LAYERS + COMPONENTS:
        yield f"stands in the unknown layer {folder}"


def include_findings(name, text):
    for bracket, path in INCLUDE.findall(text):
        if bracket == '"':
            yield f'includes "{path}": angle brackets and the full path are the rule'
        elif path.startswith("suitesparse/"):
            yield f"includes <{path}>: leave out the folder, it differs between systems"
        elif path == "Eigen/Dense" or path == "Eigen/Eigen":
            yield f"includes <{path}>: take the narrow header"
        elif path.startswith("ancf/") and not may_include(name, path[len("ancf/"):]):
            yield f"must not include <{path}>"


def form_findings(name, text):
    if not text.startswith(LICENCE):
        yield "does not open with the SPDX pair"
    described = "/// @file" in text.split("#pragma once")[0]
    if name.endswith(".hpp") and not described:
        yield "has no @file comment above #pragma once"
    if name.endswith(".ipp") and described:
        yield "has a @file comment: that of its header is enough"
    if not re.search(r"^#pragma once$", text, re.MULTILINE):
        yield "has no #pragma once"


def definition_findings(name, text, texts):
    """A header and its file of definitions belong together; nothing else includes the latter."""
    of_header = name.replace(".hpp", ".ipp")
    last = DEFINITIONS.search(text)
    if name.endswith(".hpp") and of_header in texts and (not last or last.group(1) != of_header):
        yield f"does not end with <ancf/{of_header}> unless ANCF_COMPILED"
    if name.endswith(".ipp") and f"#include <ancf/{name.replace('.ipp', '.hpp')}>" not in text:
        yield "does not include its header"
    for _, path in INCLUDE.findall(text):
        if path.endswith(".ipp") and path != f"ancf/{of_header}":
            yield f"includes <{path}>: take its header"


def reach(texts, first):
    """Returns the headers that some include, and these."""
    reached, waiting = set(), list(first)
    while waiting:
        name = waiting.pop()
        if name in texts and name not in reached:
            reached.add(name)
            waiting += [path[len("ancf/"):] for _, path in INCLUDE.findall(texts[name])
                        if path.startswith("ancf/")]
    return reached


def umbrella_findings(texts):
    """Every core header is to be had through the umbrella; what only components need, through them."""
    components = {name for name in texts if name.split("/")[0] in COMPONENTS}
    reached, used = reach(texts, [UMBRELLA]), reach(texts, components)
    for name in sorted(set(texts) - reached - components - set(ABOVE)):
        if is_public(name, texts[name]) or name not in used:
            yield f"include/ancf/{UMBRELLA}: does not reach {name}"


def is_public(name, text):
    """Whether a user has a reason to include a header: it defines or declares something outside of ancf::detail,
    a class that another header defines aside, or gathers."""
    if name.endswith(".ipp"):
        return False
    if "namespace " not in text:
        return "IWYU pragma: export" in text
    for namespace in ["ancf", *(f"ancf::{component}" for component in COMPONENTS)]:
        for body in re.findall(rf"^namespace {namespace} {{\n(.*?)^}}  // namespace {namespace}$", text, re.S | re.M):
            body = re.sub(r"namespace detail {.*?}  // namespace detail", "", body, flags=re.S)
            if re.sub(r"//.*|^(class|struct) \w+;$", "", body, flags=re.M).strip():
                return True
    return False


def types_of(text):
    """Yields the namespace and the name of every type that stands in a namespace and is no specialisation."""
    inside = []
    for line in text.splitlines():
        if opened := re.match(r"(?:inline )?namespace ([\w:]+) {", line):
            inside.append(opened.group(1))
        elif line.startswith("}  // namespace") and inside:
            inside.pop()
        elif named := re.match(r"(?:struct|class|enum class) (\w+)(?: final)?(?: [:{]|;|$)", line):
            yield "::".join(inside), named.group(1)


def name_findings(texts):
    """A type of ancf::detail hides one of ancf from whatever is included after it."""
    public, hidden = set(), {}
    for header, text in texts.items():
        for namespace, name in types_of(text):
            if namespace == "ancf":
                public.add(name)
            elif namespace == "ancf::detail":
                hidden[name] = header
    for name in sorted(public & set(hidden)):
        yield f"include/ancf/{hidden[name]}: ancf::detail::{name} hides ancf::{name}"


def count_findings(texts):
    public = [name for name, text in texts.items() if is_public(name, text)]
    if len(public) > MOST_PUBLIC:
        yield f"include/ancf: {len(public)} public headers, at most {MOST_PUBLIC}: merge some, or put into ancf::detail"


def findings(root):
    base = pathlib.Path(root) / "include" / "ancf"
    texts = {header.relative_to(base).as_posix(): header.read_text(encoding="utf-8")
             for header in sorted([*base.rglob("*.hpp"), *base.rglob("*.ipp")])}
    for name, text in texts.items():
        for rule in (place_findings(name), include_findings(name, text), form_findings(name, text),
                     definition_findings(name, text, texts)):
            for finding in rule:
                yield f"include/ancf/{name}: {finding}"
    yield from umbrella_findings(texts)
    yield from count_findings(texts)
    yield from name_findings(texts)
    if not texts:
        yield f"no header found below {base}"


def self_test():
    """Every wrong header is refused for its reason, and a right one for none."""
    bare = LICENCE + "\n#pragma once\n\n"
    opening = bare.replace("#pragma", "/// @file\n/// A header.\n\n#pragma")
    ending = "\n#if !defined(ANCF_COMPILED)\n#include <ancf/model/c.ipp>  // IWYU pragma: export\n#endif\n"
    right = {
        "section/a.hpp": opening + "#include <ancf/error.hpp>\n#include <Eigen/Core>\n",
        "model/b.hpp": opening + "#include <ancf/section/a.hpp>\n#include <ancf/model/c.hpp>\n",
        "suitesparse/d.hpp": opening + "#include <ancf/solver/e.hpp>\n#include <cholmod.h>\n",
        "ancf.hpp": opening + "#include <ancf/model/b.hpp>\n#include <ancf/error.hpp>\n",
        "model/c.hpp": opening + ending,
        "model/c.ipp": bare + "#include <ancf/model/c.hpp>\n#include <ancf/section/a.hpp>\n",
        "error.hpp": opening,
    }
    wrong = [
        ("element/a.hpp", opening + "#include <ancf/model/b.hpp>\n", "must not include"),
        ("section/a.hpp", opening + "#include <ancf/element/b.hpp>\n", "must not include"),
        ("dynamics/a.hpp", opening + "#include <ancf/output/b.hpp>\n", "must not include"),
        ("solver/a.hpp", opening + "#include <ancf/suitesparse/b.hpp>\n", "must not include"),
        ("suitesparse/a.hpp", opening + "#include <ancf/sundials/b.hpp>\n", "must not include"),
        ("sundials/a.hpp", opening + "  # include <ancf/suitesparse/b.hpp>\n", "must not include"),
        ("types.hpp", opening + "#include <ancf/section/b.hpp>\n", "must not include"),
        ("model/a.hpp", opening + "#include <ancf/ancf.hpp>\n", "must not include"),
        ("model/a.hpp", opening + "#include <ancf/nowhere/b.hpp>\n", "must not include"),
        ("ancf.hpp", opening + "#include <ancf/suitesparse/b.hpp>\n", "must not include"),
        ("ancf.hpp", opening + "#include <ancf/sundials/b.hpp>\n", "must not include"),
        ("model/a.hpp", opening + '#include "b.hpp"\n', "angle brackets"),
        ("suitesparse/a.hpp", opening + "#include <suitesparse/cholmod.h>\n", "leave out"),
        ("model/a.hpp", opening + "#include <Eigen/Dense>\n", "narrow"),
        ("stray.hpp", opening, "no layer"),
        ("contact/a.hpp", opening, "unknown layer"),
        ("model/a.hpp", opening[3:], "SPDX"),
        ("model/a.hpp", bare, "no @file"),
        ("model/a.ipp", opening, "a @file"),
        ("model/a.hpp", opening.replace("#pragma once", ""), "#pragma once"),
        ("model/a.ipp", opening.replace("#pragma once", ""), "#pragma once"),
        ("model/a.ipp", opening, "its header"),
        ("model/a.hpp", opening + ending, "take its header"),
        ("model/a.ipp", opening + "#include <ancf/output/b.hpp>\n", "must not include"),
        ("stray.ipp", opening, "no layer"),
    ]
    failures = [f"accepted: {name} ({reason})" for name, text, reason in wrong
                if not any(reason in line for line in findings_of({name: text}))]
    failures += [f"refused: {line}" for line in findings_of(right)]
    if not any("does not end" in line for line in findings_of({**right, "model/c.hpp": opening})):
        failures.append("accepted: a header that leaves its definitions out")
    if not any("does not reach" in line for line in findings_of({**right, "output/g.hpp": opening})):
        failures.append("accepted: an umbrella that leaves a header out")
    many = {f"model/h{k}.hpp": opening + "namespace ancf {\n\nclass A {};\n\n}  // namespace ancf\n" for k in range(MOST_PUBLIC + 1)}
    if not any("public headers" in line for line in findings_of(many)):
        failures.append("accepted: too many public headers")
    hiding = opening + ("namespace ancf {\n\nstruct A;\n\nnamespace detail {\n\nclass A {};\n\n"
                        "}  // namespace detail\n\n}  // namespace ancf\n")
    if not any("hides ancf::A" in line for line in findings_of({"model/a.hpp": hiding})):
        failures.append("accepted: a hidden type")
    if not findings_of({}):
        failures.append("accepted: a tree without headers")
    return failures


def findings_of(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = pathlib.Path(root) / "include" / "ancf" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return list(findings(root))


def main(argument):
    lines = self_test() if argument == "--self-test" else list(findings(argument))
    for line in lines:
        print(line)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
