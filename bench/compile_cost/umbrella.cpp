// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Everything of the core, nothing used.

#include <ancf/ancf.hpp>

int main() {}
