// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// PETSc and MPI while a program needs them.

#pragma once

#include <ancf/compiler.hpp>

#include <petscsys.h>

#include <stdexcept>
#include <string>

#if defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "ancf::petsc needs a PETSc of real numbers in double precision"
#endif

namespace ancf::petsc {

/// Starts MPI and PETSc where nobody has, and ends what it started.
///
///     int main(int argc, char** argv) {
///         const ancf::petsc::Session session(&argc, &argv);  // before everything of ancf::petsc
///
/// A program that calls PetscInitialize itself needs none. Errors of PETSc inside this library are
/// statuses or exceptions: they print nothing and abort nothing.
class Session {
public:
    /// Reads PETSc's options from the command line.
    /// @throws std::runtime_error where PETSc does not start.
    explicit Session(int* argc = nullptr, char*** argv = nullptr);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    /// Returns the number of this process, from 0.
    [[nodiscard]] static int rank(MPI_Comm comm = PETSC_COMM_WORLD);
    /// Returns the number of processes.
    [[nodiscard]] static int ranks(MPI_Comm comm = PETSC_COMM_WORLD);

private:
    bool own_ = false;
};

namespace detail {

/// What a call of PETSc returned.
class PetscFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// While one stands, errors of PETSc are texts that check() throws.
class QuietErrors {
public:
    QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors();
};

/// Throws PetscFailure with PETSc's own words, unless the code is zero.
void check(PetscErrorCode code);

/// Throws where PETSc does not run.
void require_session();

}  // namespace detail
}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/session.ipp>  // IWYU pragma: export
#endif
