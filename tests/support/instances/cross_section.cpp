// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#define ANCF_TEST_CROSS_SECTION
#include <support/instances/cross_section.hpp>
