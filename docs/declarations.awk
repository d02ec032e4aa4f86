# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Doxygen's view of a header: blanks what defines a member outside its class, as Doxygen 1.9 does not join such a
# definition with the documented declaration where templates nest. Lines keep their numbers.

function finish(drop,    k) {
    for (k = 1; k <= held; ++k) print drop ? "" : line[k]
    held = 0
    head = ""
    class = body = 0
}

FILENAME ~ /\.md$/ { print; next }
held == 0 && !/^(template <|inline |constexpr |[A-Za-z][A-Za-z0-9:<>, ]* )/ { print; next }
held == 0 && /^(class|struct|enum|namespace|using|extern|public|private)/ { print; next }
{
    line[++held] = $0
    if (/^(class|struct)/) class = 1
    if (!body) {
        head = head " " $0
        if (/\{/) body = 1
        else if (/;[ \t]*$/) { finish(0); next }
    }
    if (body && (/^\}/ || (!/^ / && /\}[ \t]*$/))) {
        sub(/\(.*/, "", head)
        finish(!class && head ~ /[A-Z][A-Za-z0-9]*(<.*>)?::(operator|~?[A-Za-z_0-9]+)[^ ]*$/)
    }
}
END { finish(0) }
