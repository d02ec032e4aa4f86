// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// All of the core, which needs Eigen alone. The components suitesparse, sundials and petsc
/// are included by name.
///
/// It is the quick way in; the narrower headers compile faster.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/output/time_series.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/polygon.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/section/section.hpp>
#include <ancf/section/stiffness.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/richardson.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/solver/solver_named.hpp>
#include <ancf/solver/stability.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>
#include <ancf/version.hpp>

/// @namespace ancf
/// Everything of the core: sections, elements, models and what builds them, assembly, linear
/// solvers, statics, motion and output. SI units throughout; angles in rad.

/// @namespace ancf::suitesparse
/// Linear solvers of SuiteSparse: the component of that name.

/// @namespace ancf::sundials
/// IDA of SUNDIALS as integrator: the component of that name.

/// @namespace ancf::petsc
/// Solvers of PETSc, and statics by several processes: the component of that name.
