// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A session of PETSc; its errors as exceptions, and its objects with an owner.

#pragma once

#include <ancf/compiler.hpp>

#include <petscsys.h>

#include <utility>

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
    bool own_;
};

namespace detail {

/// While one stands, errors of PETSc print nothing: check() throws them.
class QuietErrors {
public:
    /// @throws InvalidArgument where PETSc does not run.
    QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors();
};

/// Throws std::runtime_error with PETSc's own words, unless the code is zero.
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

}  // namespace detail
}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/session.ipp>  // IWYU pragma: export
#endif
