// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// All constraints (joints) of the library.

#pragma once

#include <ancf/model/constraints_frames.hpp>
#include <ancf/model/constraints_joints.hpp>
#include <ancf/model/constraints_motion.hpp>
#include <ancf/model/constraints_planar.hpp>
#include <ancf/model/constraints_points.hpp>
#include <ancf/model/constraints_sections.hpp>
