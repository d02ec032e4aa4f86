// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Tests under mpirun: PETSc runs around all of them, and takes none of Catch's arguments.

#define CATCH_CONFIG_RUNNER
#include <ancf/petsc/solver.hpp>

#include <support/catch.hpp>

int main(int argc, char** argv) {
    // what follows "--" is PETSc's
    int own = 1;
    while (own < argc && std::string(argv[own]) != "--") ++own;
    int rest = argc - own < 1 ? 1 : argc - own;
    char** options = own < argc ? argv + own : argv;
    const ancf::petsc::Session session(&rest, &options);
    return Catch::Session().run(own, argv);
}
