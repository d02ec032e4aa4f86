// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// All constraints (joints) of the library.

#pragma once

#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/constraints/motion.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/constraints/slider.hpp>
