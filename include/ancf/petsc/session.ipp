// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of session.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/session.hpp>

#include <stdexcept>
#include <string>

namespace ancf::petsc {
namespace detail {

/// Tells whether PETSc runs.
[[nodiscard]] ANCF_INLINE bool petsc_runs() {
    PetscBool started = PETSC_FALSE;
    check(PetscInitialized(&started));
    return started != PETSC_FALSE;
}

ANCF_INLINE QuietErrors::QuietErrors() {
    ancf::detail::require(petsc_runs(),
                          "ancf::petsc: PETSc does not run; let an ancf::petsc::Session stand");
    static_cast<void>(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

ANCF_INLINE QuietErrors::~QuietErrors() { static_cast<void>(PetscPopErrorHandler()); }

ANCF_INLINE void check(PetscErrorCode code) {
    if (code == 0) return;
    const char* kind = nullptr;
    char* words = nullptr;  // of the place where it arose
    static_cast<void>(PetscErrorMessage(code, &kind, &words));
    std::string text = "PETSc: " + std::string(kind != nullptr ? kind : "error");
    if (words != nullptr && *words != '\0') text += ": " + std::string(words);
    while (text.back() == '\n') text.pop_back();
    throw std::runtime_error(text);
}

}  // namespace detail

ANCF_INLINE Session::Session(int* argc, char*** argv) : own_(!detail::petsc_runs()) {
    if (own_) detail::check(PetscInitialize(argc, argv, nullptr, nullptr));
}

ANCF_INLINE Session::~Session() {
    if (own_) static_cast<void>(PetscFinalize());
}

ANCF_INLINE int Session::rank(MPI_Comm comm) {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

ANCF_INLINE int Session::ranks(MPI_Comm comm) {
    int ranks = 1;
    MPI_Comm_size(comm, &ranks);
    return ranks;
}

}  // namespace ancf::petsc
