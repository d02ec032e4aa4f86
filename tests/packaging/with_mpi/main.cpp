// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Compiles where what the stand-in of SUNDIALS names reached this target.

#if defined(EXPECTS_OWN_MPI_C)
#if !defined(OWN_MPI_C) || defined(FOUND_MPI_CXX)
#error "the project's own MPI::MPI_C was replaced"
#endif
#elif !defined(FOUND_MPI_CXX)
#error "MPI::MPI_C does not stand for the MPI of C++"
#endif

int main() { return 0; }
