// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How a scene is divided between processes, and which row each unknown has.
///
/// Every process has the whole scene and finds the same division. A node belongs to one process; an
/// element to that of its first node; an attached node to that of its element. A process holds its
/// elements, its nodes and all nodes that these touch.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/model/exchange.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/petsc/errors.hpp>
#include <ancf/types.hpp>

#include <petscsf.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ancf::petsc::detail {

/// Returns a number as a place in a vector.
[[nodiscard]] inline std::size_t at(int k) noexcept { return static_cast<std::size_t>(k); }

/// The division of one scene, and what its parts tell each other.
class Partition final : public ancf::detail::Exchange {
public:
    /// Divides by PETSc's MatPartitioning: PT-Scotch where PETSc has it, or as the option
    /// -PREFIXmat_partitioning_type says; few nodes in the order of their numbers. Collective.
    /// @param whole  the same in every process; it outlives the partition.
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
        return own_[static_cast<std::size_t>(coordinate)] != 0;
    }
    ANCF_INLINE_VIRTUAL void sum(double* values, int count) const override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL double largest(double value) const override;
    [[nodiscard]] int element(int group, int element) const noexcept override {
        return held_.elements[static_cast<std::size_t>(group)][static_cast<std::size_t>(element)];
    }
    [[nodiscard]] const std::vector<AnyConstraint>& constraints() const noexcept override {
        return whole_.constraints();
    }

    /// Returns the number in this part of an element of a group of the whole scene; -1 of others'.
    /// @throws InvalidArgument for a group that the scene gained after it was divided.
    [[nodiscard]] int number_in_part(const ElementGroup& group, int element) const;

    /// Returns the coordinates of the whole scene, in every process. Collective.
    /// @param of_part  coordinates, rates or forces of the part.
    [[nodiscard]] VectorX gather(const VectorX& of_part) const;
    /// Returns the multipliers of the whole scene likewise.
    [[nodiscard]] VectorX gather_multipliers(const VectorX& of_part) const;

    // Rows of the global system ----------------------------------------------------------------

    /// The rows of the equations of a part.
    struct Rows {
        std::vector<PetscInt> row;           ///< of each equation; -1 of one that is eliminated
        std::vector<char> own;               ///< whether this process has that row
        std::vector<std::vector<int>> sets;  ///< of equations that are eliminated together
        std::vector<PetscInt> idle;          ///< own rows without an equation
    };

    /// Returns the number of rows that form a block: those of a node where all nodes are alike,
    /// else those of a vector; 1 with multipliers.
    [[nodiscard]] int block_size() const noexcept { return block_; }
    /// Tells whether a block is that of a node with slopes.
    [[nodiscard]] bool blocks_are_nodes() const noexcept {
        return by_node_ && block_ > whole_.dimension();
    }
    /// Returns the first row of this process, and one past its last.
    [[nodiscard]] PetscInt first_row() const noexcept { return first_row_; }
    [[nodiscard]] PetscInt last_row() const noexcept { return last_row_; }

    /// Returns the rows of the equations of the part that this process holds.
    [[nodiscard]] Rows rows(const Scene& part, const Numbering& numbering) const;

private:
    void follow();
    void divide(const std::string& prefix);
    void assign_elements();
    void eliminate();
    void hold();
    void number_rows();
    void connect();
    // Calls visit(node) for a node and those it follows.
    template <class Visitor>
    void visit_all(int node, const Visitor& visit) const;
    // Returns the node that stands for one: itself, or the first that it follows.
    [[nodiscard]] int leader(int node) const {
        return followed_.empty() || followed_[static_cast<std::size_t>(node)].empty()
                   ? node
                   : followed_[static_cast<std::size_t>(node)].front();
    }

    const Scene& whole_;
    MPI_Comm comm_;
    int rank_, ranks_;
    std::vector<std::vector<int>> followed_;  // by each node; none without attachments
    std::vector<int> owner_;                  // of each node
    std::vector<char> eliminated_;            // whether the unknowns of a node are
    std::vector<int> constraint_owner_;
    ScenePart held_;

    int block_ = 1;
    bool by_node_ = false;
    std::vector<PetscInt> node_row_;        // first row of each node, -1 without
    std::vector<PetscInt> constraint_row_;  // of each constraint
    PetscInt first_row_ = 0, last_row_ = 0;

    std::vector<char> own_;  // of each coordinate of the part
    std::vector<int> mine_;  // own coordinates, in the order of the roots
    std::vector<int> rim_;   // the others, in the order of the leaves
    Handle<PetscSF> shared_;
    mutable std::vector<double> roots_, leaves_;
};

}  // namespace ancf::petsc::detail

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/partition.ipp>  // IWYU pragma: export
#endif
