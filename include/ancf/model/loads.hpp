// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// All loads of the library: dead and following forces and moments.

#pragma once

#include <ancf/model/loads/forces.hpp>
#include <ancf/model/loads/moments.hpp>
