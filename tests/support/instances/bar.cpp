// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#define ANCF_TEST_BAR
#include <support/instances/bar.hpp>
