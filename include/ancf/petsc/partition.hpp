// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How a scene is divided between processes, and which row each unknown has.
///
/// Every process has the whole scene and finds the same division, of model/division.hpp.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/model/division.hpp>
#include <ancf/model/exchange.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/petsc/session.hpp>
#include <ancf/types.hpp>

#include <petscsf.h>

#include <string>
#include <vector>

namespace ancf::petsc::detail {

/// The rows of the equations of a part in the system of all parts.
struct Rows {
    PetscInt first = 0, last = 0;       ///< its rows are first to last - 1
    int block = 1;                      ///< how many rows form a block
    std::vector<PetscInt> of_equation;  ///< row of each one; -1 of one that is eliminated
    List<List<int>> sets;               ///< of equations that are eliminated together, ascending
    std::vector<PetscInt> idle;         ///< own rows without an equation

    /// Tells whether this process has a row.
    [[nodiscard]] bool own(PetscInt k) const noexcept { return k >= first && k < last; }
};

/// The division of one scene, and what its parts tell each other.
class Partition final : public ancf::detail::Exchange {
public:
    /// Divides by PETSc's MatPartitioning: PT-Scotch where PETSc has it, or as the option
    /// -PREFIXmat_partitioning_type says; few nodes in the order of their numbers. Collective.
    /// @param whole  the same in every process; it outlives the partition.
    /// @throws InvalidArgument where PETSc does not run.
    /// @throws std::runtime_error with PETSc's words where it fails.
    Partition(const Scene& whole, MPI_Comm comm, const std::string& prefix = {});
    Partition(const Partition&) = delete;
    Partition& operator=(const Partition&) = delete;
    ANCF_INLINE_VIRTUAL ~Partition() override;

    /// Returns the processes.
    [[nodiscard]] MPI_Comm comm() const noexcept { return comm_; }
    /// Returns the whole scene.
    [[nodiscard]] const Scene& whole() const noexcept { return whole_; }
    /// Returns what this process holds.
    [[nodiscard]] const ScenePart& held() const noexcept { return held_; }

    ANCF_INLINE_VIRTUAL void add(VectorX& forces) const override;
    [[nodiscard]] bool owns(int coordinate) const noexcept override {
        return own_[coordinate] != 0;
    }
    ANCF_INLINE_VIRTUAL void sum(double* values, int count) const override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL double largest(double value) const override;
    [[nodiscard]] int element(int group, int element) const noexcept override {
        return held_.elements[group][element];
    }
    [[nodiscard]] const List<AnyConstraint>& constraints() const noexcept override {
        return whole_.constraints();
    }
    [[nodiscard]] int load(int load) const noexcept override { return held_.loads[load]; }
    [[nodiscard]] int constraint(int constraint) const noexcept override {
        return held_.constraints[constraint];
    }

    /// Returns an element's number in this part; -1 where another process has it. `element` is its
    /// number in the whole scene.
    /// @throws InvalidArgument for a group that the scene gained after it was divided.
    [[nodiscard]] int number_in_part(const ElementGroup& group, int element) const;

    /// Returns the coordinates of the whole scene, in every process. Collective.
    /// @param of_part  coordinates, rates or forces of the part.
    [[nodiscard]] VectorX gather(const VectorX& of_part) const;
    /// Returns the multipliers of the whole scene likewise.
    [[nodiscard]] VectorX gather_multipliers(const VectorX& of_part) const;

    /// Returns the rows of the equations of the part that this process holds. A block is a node
    /// where all nodes are alike, else a vector; with multipliers it is one row. Collective.
    [[nodiscard]] Rows rows(const Scene& part, const Numbering& numbering) const;

private:
    const Scene& whole_;
    MPI_Comm comm_;
    ancf::detail::Division division_;
    int rank_;
    ScenePart held_;
    std::vector<char> own_;  // of each coordinate of the part
    // leaves: the coordinates of each part; roots: the coordinates that each process owns
    Handle<PetscSF> shared_;
    mutable std::vector<double> sums_;
};

}  // namespace ancf::petsc::detail

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/partition.ipp>  // IWYU pragma: export
#endif
