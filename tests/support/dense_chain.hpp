// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A few elements in a row, solved by a dense Newton method: statics without the library's own.

#pragma once

#include <ancf/types.hpp>

#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <vector>

namespace ancf::test {

/// Equal elements along e_x, clamped at the origin as in [Dufva2006, section 5.2]: r, r_y, r_z
/// fixed, r_x free.
template <class Element>
class DenseChain {
public:
    static constexpr int dimension = Element::dimension;
    static constexpr int node_dofs = Element::dofs / 2;

    DenseChain(const Element& element, int elements) : element_(element), elements_(elements) {
        state_.resize(node_dofs * (elements + 1));
        const auto reference = reference_coordinates(element);
        for (int node = 0; node <= elements; ++node) {
            state_.template segment<node_dofs>(node_dofs * node) =
                reference.template head<node_dofs>();
            state_(node_dofs * node) = node * element.length();
        }
        for (int i = 0; i < state_.size(); ++i) {
            const int first = dimension * Element::fields.rank(Field::r_x);
            if (i >= node_dofs || (i >= first && i < first + dimension)) free_.push_back(i);
        }
    }

    [[nodiscard]] Vector<double, Element::dofs> element_state(int k) const {
        return state_.template segment<Element::dofs>(node_dofs * k);
    }

    /// Returns the position of the last node.
    [[nodiscard]] Vector<double, dimension> tip() const {
        return state_.template segment<dimension>(node_dofs * elements_);
    }

    /// Solves for a dead force at the last node.
    /// @return the number of iterations to a residual of `tolerance` of the force, or -1
    int solve(const Vector<double, dimension>& force, double tolerance = 1e-9, int limit = 60) {
        const auto size = static_cast<Eigen::Index>(free_.size());
        for (int iteration = 0; iteration <= limit; ++iteration) {
            MatrixX tangent = MatrixX::Zero(state_.size(), state_.size());
            VectorX residual = VectorX::Zero(state_.size());
            for (int k = 0; k < elements_; ++k) {
                const auto evaluation = element_.evaluate(element_state(k));
                tangent.template block<Element::dofs, Element::dofs>(
                    node_dofs * k, node_dofs * k) += evaluation.tangent;
                residual.template segment<Element::dofs>(node_dofs * k) += evaluation.force;
            }
            residual.template segment<dimension>(node_dofs * elements_) -= force;
            MatrixX K(size, size);
            VectorX r(size);
            for (Eigen::Index i = 0; i < size; ++i) {
                r(i) = residual(free_[static_cast<std::size_t>(i)]);
                for (Eigen::Index j = 0; j < size; ++j) {
                    K(i, j) = tangent(free_[static_cast<std::size_t>(i)],
                                      free_[static_cast<std::size_t>(j)]);
                }
            }
            if (r.norm() <= tolerance * force.norm()) return iteration;
            const VectorX step = test::solved(K, r);
            for (Eigen::Index i = 0; i < size; ++i)
                state_(free_[static_cast<std::size_t>(i)]) -= step(i);
        }
        return -1;
    }

private:
    Element element_;
    int elements_;
    VectorX state_;
    std::vector<int> free_;
};

}  // namespace ancf::test
