// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of errors.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/errors.hpp>

namespace ancf::petsc::detail {

/// The text of the last error, of the place where it arose.
[[nodiscard]] ANCF_INLINE std::string& error_text() {
    static std::string text;
    return text;
}

extern "C" {
/// Keeps the words of an error and lets the calls return.
inline PetscErrorCode ancf_keep_petsc_error(MPI_Comm, int, const char*, const char*,
                                            PetscErrorCode code, PetscErrorType type,
                                            const char* message, void*) {
    if (type == PETSC_ERROR_INITIAL) error_text() = message != nullptr ? message : "";
    return code;
}
}

ANCF_INLINE QuietErrors::QuietErrors() {
    error_text().clear();
    static_cast<void>(PetscPushErrorHandler(ancf_keep_petsc_error, nullptr));
}

ANCF_INLINE QuietErrors::~QuietErrors() { static_cast<void>(PetscPopErrorHandler()); }

ANCF_INLINE void check(PetscErrorCode code) {
    if (code == 0) return;
    const char* kind = nullptr;
    static_cast<void>(PetscErrorMessage(code, &kind, nullptr));
    std::string text = "PETSc: " + std::string(kind != nullptr ? kind : "error");
    if (!error_text().empty()) text += ": " + error_text();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    throw PetscFailure(text);
}

ANCF_INLINE bool petsc_runs() {
    PetscBool started = PETSC_FALSE;
    check(PetscInitialized(&started));
    return started != PETSC_FALSE;
}

ANCF_INLINE void require_session() {
    ancf::detail::require(petsc_runs(),
                          "ancf::petsc: PETSc does not run; let an ancf::petsc::Session stand");
}

ANCF_INLINE int rank_in(MPI_Comm comm) {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

ANCF_INLINE int ranks_in(MPI_Comm comm) {
    int ranks = 1;
    MPI_Comm_size(comm, &ranks);
    return ranks;
}

}  // namespace ancf::petsc::detail
