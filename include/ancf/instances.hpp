// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// For programs of several translation units: compile what they share once.
///
/// Declare the instances in a header of the program, define them in one of its units, and every
/// other unit takes a fraction of the time to compile:
///
///     // scene.hpp, after the headers of the elements, solvers and integrators used
///     #ifndef SCENE_INSTANCES
///     #define SCENE_INSTANCES extern
///     #endif
///     ANCF_SOLVER_INSTANCES(SCENE_INSTANCES);
///     ANCF_ELEMENT_INSTANCES(SCENE_INSTANCES, ancf::CrossSectionBeam<3>);
///     ANCF_STATICS_INSTANCES(SCENE_INSTANCES, ancf::CrossSectionBeam<3>);
///
///     // scene.cpp
///     #define SCENE_INSTANCES
///     #include "scene.hpp"
///
/// The macros stand in the global namespace. KIND is `extern`, or nothing where the instances are
/// defined. The element comes last; it may contain commas.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/solver/turning.hpp>

/// Eigen's sparse direct solvers.
#define ANCF_SOLVER_INSTANCES(KIND)                                                      \
    KIND template class Eigen::SparseLU<ancf::SparseMatrix, Eigen::COLAMDOrdering<int>>; \
    KIND template class Eigen::SimplicialLDLT<ancf::SparseMatrix, Eigen::Lower,          \
                                              Eigen::AMDOrdering<int>>

/// An element, the model of such elements and what assembles and corrects it.
#define ANCF_ELEMENT_INSTANCES(KIND, ...)                         \
    KIND template class __VA_ARGS__;                              \
    KIND template class ancf::Model<__VA_ARGS__>;                 \
    KIND template class ancf::Assembly<ancf::Model<__VA_ARGS__>>; \
    KIND template class ancf::Turning<ancf::Model<__VA_ARGS__>>

/// Newton's method.
#define ANCF_STATICS_INSTANCES(KIND, ...) \
    KIND template class ancf::detail::StaticsRun<ancf::Model<__VA_ARGS__>>
