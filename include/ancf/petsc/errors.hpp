// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Errors of PETSc as exceptions, its objects with an owner, and who a process is.

#pragma once

#include <ancf/compiler.hpp>

#include <petscsys.h>

#include <stdexcept>
#include <string>
#include <utility>

#if defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "ancf::petsc needs a PETSc of real numbers in double precision"
#endif

namespace ancf::petsc::detail {

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

/// Owns an object of PETSc.
template <class Object>
class Handle {
public:
    Handle() = default;
    Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Handle& operator=(Handle&&) = delete;
    ~Handle() { reset(); }

    operator Object() const noexcept { return object_; }  // NOLINT(google-explicit-constructor)

    /// Destroys it, and gives the place of another.
    [[nodiscard]] Object* fresh() {
        reset();
        return &object_;
    }
    /// Destroys it.
    void reset() {
        static_cast<void>(PetscObjectDestroy(reinterpret_cast<PetscObject*>(&object_)));
    }

private:
    Object object_ = nullptr;
};

/// Tells whether PETSc runs.
[[nodiscard]] bool petsc_runs();

/// Throws InvalidArgument where it does not.
void require_session();

/// Returns the number of this process among those of a communicator, from 0.
[[nodiscard]] int rank_in(MPI_Comm comm);
/// Returns how many there are.
[[nodiscard]] int ranks_in(MPI_Comm comm);

}  // namespace ancf::petsc::detail

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/errors.ipp>  // IWYU pragma: export
#endif
