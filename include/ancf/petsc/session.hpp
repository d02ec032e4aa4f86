// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A session of PETSc; its errors as exceptions, and its objects with an owner.

#pragma once

#include <ancf/error.hpp>

#include <petscsys.h>

#include <stdexcept>
#include <string>
#include <utility>

#if defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "ancf::petsc needs a PETSc of real numbers in double precision"
#endif

namespace ancf::petsc {

namespace detail {

/// Throws std::runtime_error with PETSc's own words, unless the code is zero.
inline void check(PetscErrorCode code) {
    if (code == 0) return;
    const char* kind = nullptr;
    char* words = nullptr;  // of the last error that began anywhere, as a rule this one
    static_cast<void>(PetscErrorMessage(code, &kind, &words));
    std::string text = std::string("PETSc: ") + (kind != nullptr ? kind : "error");
    if (words != nullptr && *words != '\0') text.append(": ").append(words);
    while (text.back() == '\n') text.pop_back();
    throw std::runtime_error(text);
}

/// Tells whether PETSc runs.
[[nodiscard]] inline bool petsc_runs() {
    PetscBool started = PETSC_FALSE;
    check(PetscInitialized(&started));
    return started != PETSC_FALSE;
}

/// While one stands, errors of PETSc print nothing: check() throws them.
class QuietErrors {
public:
    /// @throws InvalidArgument where PETSc does not run.
    QuietErrors() {
        ancf::detail::require(petsc_runs(),
                              "ancf::petsc: PETSc is not initialised; make an "
                              "ancf::petsc::Session first and keep it");
        static_cast<void>(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors() { static_cast<void>(PetscPopErrorHandler()); }
};

/// Owns an object of PETSc.
template <class Object>
class Handle {
public:
    Handle() = default;
    Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Handle& operator=(Handle&&) = delete;
    ~Handle() { static_cast<void>(fresh()); }

    operator Object() const noexcept { return object_; }  // NOLINT(google-explicit-constructor)

    /// Destroys it, and gives the place of another.
    [[nodiscard]] Object* fresh() {
        static_cast<void>(PetscObjectDestroy(reinterpret_cast<PetscObject*>(&object_)));
        return &object_;
    }

private:
    Object object_ = nullptr;
};

}  // namespace detail

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
    explicit Session(int* argc = nullptr, char*** argv = nullptr) : own_(!detail::petsc_runs()) {
        if (own_) detail::check(PetscInitialize(argc, argv, nullptr, nullptr));
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() {
        if (own_) static_cast<void>(PetscFinalize());
    }

    /// Returns the number of this process, from 0.
    [[nodiscard]] static int rank(MPI_Comm comm = PETSC_COMM_WORLD) {
        int rank = 0;
        MPI_Comm_rank(comm, &rank);
        return rank;
    }
    /// Returns the number of processes.
    [[nodiscard]] static int ranks(MPI_Comm comm = PETSC_COMM_WORLD) {
        int ranks = 1;
        MPI_Comm_size(comm, &ranks);
        return ranks;
    }

private:
    bool own_;
};

}  // namespace ancf::petsc
