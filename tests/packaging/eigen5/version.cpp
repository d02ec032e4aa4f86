// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/ancf.hpp>

static_assert(EIGEN_MAJOR_VERSION >= 5, "another Eigen was found first");
