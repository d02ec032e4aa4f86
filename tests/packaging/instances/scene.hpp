// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the units of this program share: scene.cpp defines it, the others only declare it.

#pragma once

#include <ancf/element/planar_beam.hpp>
#include <ancf/instances.hpp>
#include <ancf/model/builders/beam.hpp>

#ifndef SCENE_INSTANCES
#define SCENE_INSTANCES extern
#endif
ANCF_ELEMENT_INSTANCES(SCENE_INSTANCES, ancf::CrossSectionBeam<2>);
ANCF_STATICS_INSTANCES(SCENE_INSTANCES, ancf::CrossSectionBeam<2>);
