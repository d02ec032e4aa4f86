// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Which coordinates are unknowns, and which equation each has.
///
/// Equations follow the nodes; the multipliers of the constraints come last. Each node and each
/// constraint is one block of the system.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <cstddef>

namespace ancf {

/// The equations of a scene.
class Numbering {
public:
    Numbering() = default;

    /// @throws InvalidArgument for a support on a vector that its node does not carry.
    explicit Numbering(const Scene& model);

    /// Returns the number of equations: free coordinates, then multipliers.
    [[nodiscard]] int unknowns() const noexcept { return free_ + multipliers_; }
    /// Returns how many coordinates are unknowns.
    [[nodiscard]] int free_coordinates() const noexcept { return free_; }
    /// Returns the number of multipliers.
    [[nodiscard]] int multipliers() const noexcept { return multipliers_; }
    /// Returns the number of all coordinates.
    [[nodiscard]] int coordinates() const noexcept { return static_cast<int>(equation_.size()); }

    /// Returns the equation of a coordinate, -1 where a support holds it or it is attached.
    [[nodiscard]] int equation(int coordinate) const noexcept { return equation_[coordinate]; }

    /// Returns the equations of all coordinates.
    [[nodiscard]] const int* equations() const noexcept { return equation_.data(); }

    /// Returns the node, and so the block, of a coordinate.
    [[nodiscard]] int block(int coordinate) const noexcept { return block_[coordinate]; }

    /// Returns the block of a constraint.
    [[nodiscard]] int constraint_block(int constraint) const noexcept {
        return nodes_ + constraint;
    }

    /// Returns the number of equations of each block.
    [[nodiscard]] const List<int>& block_sizes() const noexcept { return sizes_; }

    /// Returns the supported coordinates in ascending order.
    [[nodiscard]] const List<int>& held() const noexcept { return held_; }

    /// Returns what attached vectors follow.
    [[nodiscard]] const Dependence& dependence() const noexcept { return dependence_; }

    /// Copies the free entries of a vector of coordinates, or of forces that are carried.
    void gather_free(const VectorX& coordinates, VectorX& free) const {
        free.resize(free_);
        for (std::size_t k = 0; k < equation_.size(); ++k)
            if (equation_[k] >= 0) free[equation_[k]] = coordinates[static_cast<Eigen::Index>(k)];
    }

    /// Writes the free entries of a vector of coordinates; what is attached to them stays.
    void set_free(const VectorX& free, VectorX& coordinates) const {
        for (std::size_t k = 0; k < equation_.size(); ++k)
            if (equation_[k] >= 0) coordinates[static_cast<Eigen::Index>(k)] = free[equation_[k]];
    }

    /// Adds to the free entries of a vector of coordinates, and to what is attached to them.
    void add_free(const VectorX& free, double scale, VectorX& coordinates) const {
        add_free_force(free, scale, coordinates);
        dependence_.complete(coordinates);
    }

    /// Adds to the free entries of a vector of forces.
    void add_free_force(const VectorX& free, double scale, VectorX& forces) const {
        for (std::size_t k = 0; k < equation_.size(); ++k)
            if (equation_[k] >= 0)
                forces[static_cast<Eigen::Index>(k)] += scale * free[equation_[k]];
    }

private:
    int nodes_ = 0;
    int free_ = 0;
    int multipliers_ = 0;
    List<int> equation_;
    List<int> block_;
    List<int> sizes_;
    List<int> held_;
    Dependence dependence_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/assembly/numbering.ipp>
#endif
