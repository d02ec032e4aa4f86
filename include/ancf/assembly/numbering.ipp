// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/error.hpp>

namespace ancf {

ANCF_INLINE Numbering::Numbering(const Scene& model) {
    const Layout& layout = model.layout();
    nodes_ = layout.nodes();
    dependence_ = model.dependence();
    equation_.assign(static_cast<std::size_t>(layout.size()), 0);
    block_.resize(equation_.size());
    for (const Support& support : model.supports()) {
        const int first = layout.index({support.node, support.field});
        detail::require(first >= 0, "a support holds ", to_string(support.field), " of node ",
                        support.node.index,
                        ", which carries no such vector: no element there has one",
                        support.field == Field::r ? ", and no mass" : "");
        equation_[first + support.component] = -1;
    }
    sizes_.assign(static_cast<std::size_t>(nodes_), 0);
    for (int node = 0; node < nodes_; ++node)
        for (int k = layout.first(node); k < layout.first(node + 1); ++k) {
            const auto at = static_cast<std::size_t>(k);
            block_[at] = node;
            if (dependence_.attached(k)) {
                equation_[at] = -1;
            } else if (equation_[at] < 0) {
                held_.push_back(k);
            } else {
                equation_[at] = free_++;
                ++sizes_[node];
            }
        }
    for (const AnyConstraint& constraint : model.constraints()) {
        sizes_.push_back(constraint.equations());
        multipliers_ += constraint.equations();
    }
}

}  // namespace ancf
