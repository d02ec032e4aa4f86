// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Forces and moments, dead and following. Damping and springs have headers of their own.

#pragma once

#include <ancf/model/loads/forces.hpp>
#include <ancf/model/loads/moments.hpp>
