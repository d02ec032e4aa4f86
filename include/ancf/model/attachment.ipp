// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/attachment.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace ancf {

ANCF_INLINE Dependence::Dependence(const Layout& layout, const List<AttachedVector>& attachments)
    : dimension_(layout.dimension()) {
    if (attachments.empty()) return;
    vector_of_.assign(static_cast<std::size_t>(layout.size()), -1);
    for (const AttachedVector& attachment : attachments) {
        const int first = layout.index(attachment.vector);
        for (int k = 0; k < dimension_; ++k)
            vector_of_[first + k] = static_cast<int>(firsts_.size());
        firsts_.push_back(first);
        first_part_.push_back(static_cast<int>(parts_.size()));
        for (std::size_t k = 0; k < attachment.factors.size(); ++k)
            if (attachment.factors[k] != 0.0)
                parts_.push_back(
                    {layout.index({attachment.to, static_cast<Field>(k)}), attachment.factors[k]});
    }
    first_part_.push_back(static_cast<int>(parts_.size()));
    while (!resolve()) {
    }
    list_followers(layout.size());
}

// Chains: a part that is attached itself gives way to its own parts.
ANCF_INLINE bool Dependence::resolve() {
    bool resolved = true;
    const List<Part> given = std::exchange(parts_, {});
    const List<int> first_given = first_part_;
    const auto add = [&](std::size_t to, int first, double factor) {
        auto same = static_cast<std::size_t>(first_part_[to]);
        while (same < parts_.size() && parts_[same].first != first) ++same;
        if (same == parts_.size())
            parts_.push_back({first, factor});
        else
            parts_[same].factor += factor;
    };
    for (std::size_t k = 0; k < firsts_.size(); ++k) {
        first_part_[k] = static_cast<int>(parts_.size());
        for (int p = first_given[k]; p < first_given[k + 1]; ++p) {
            const Part part = given[p];
            if (!attached(part.first)) {
                add(k, part.first, part.factor);
                continue;
            }
            resolved = false;
            const auto of = static_cast<std::size_t>(vector_of_[part.first]);
            const bool done = of < k;  // in this pass
            const List<int>& from = done ? first_part_ : first_given;
            for (int own = from[of]; own < from[of + 1]; ++own) {
                const Part next = (done ? parts_ : given)[own];
                add(k, next.first, part.factor * next.factor);
            }
        }
    }
    first_part_.back() = static_cast<int>(parts_.size());
    return resolved;
}

ANCF_INLINE void Dependence::list_followers(int coordinates) {
    first_follower_.assign(static_cast<std::size_t>(coordinates) + 1, 0);
    for (const Part& part : parts_) ++first_follower_[static_cast<std::size_t>(part.first) + 1];
    for (std::size_t k = 1; k < first_follower_.size(); ++k)
        first_follower_[k] += first_follower_[k - 1];
    List<int> next = first_follower_;
    followers_.resize(parts_.size());
    for (std::size_t k = 0; k < firsts_.size(); ++k)
        for (int p = first_part_[k]; p < first_part_[k + 1]; ++p) {
            const auto of = static_cast<std::size_t>(parts_[p].first);
            followers_[next[of]++] = static_cast<int>(k);
        }
}

ANCF_INLINE List<Dependence::Part> Dependence::parts(int first) const {
    List<Part> all;
    if (!attached(first)) {
        all.push_back({first, 1.0});
        return all;
    }
    const auto of = static_cast<std::size_t>(vector_of_[first]);
    for (int p = first_part_[of]; p < first_part_[of + 1]; ++p) all.push_back(parts_[p]);
    return all;
}

ANCF_INLINE void Dependence::complete(VectorX& coordinates, int first) const {
    if (empty()) return;
    const auto of = static_cast<std::size_t>(first);
    for (int k = first_follower_[of]; k < first_follower_[of + 1]; ++k)
        complete_one(coordinates, static_cast<std::size_t>(followers_[k]));
}

ANCF_INLINE void Dependence::complete_one(VectorX& coordinates, std::size_t attached) const {
    for (int i = 0; i < dimension_; ++i) {
        double sum = 0.0;
        for (int p = first_part_[attached]; p < first_part_[attached + 1]; ++p) {
            const Part& part = parts_[p];
            sum += part.factor * coordinates[part.first + i];
        }
        coordinates[firsts_[attached] + i] = sum;
    }
}

ANCF_INLINE void Dependence::carry(VectorX& forces) const {
    for (std::size_t k = 0; k < firsts_.size(); ++k)
        for (int i = 0; i < dimension_; ++i) {
            double& force = forces[firsts_[k] + i];
            for (int p = first_part_[k]; p < first_part_[k + 1]; ++p) {
                const Part& part = parts_[p];
                forces[part.first + i] += part.factor * force;
            }
            force = 0.0;
        }
}

namespace detail {

ANCF_INLINE FollowedVectors::FollowedVectors(const Dependence& dependence, const List<int>& list) {
    for (const int own : list) {
        first_part.push_back(static_cast<int>(parts.size()));
        for (const Dependence::Part& part : dependence.parts(own)) {
            const auto found = std::find(firsts.begin(), firsts.end(), part.first);
            parts.push_back({static_cast<int>(found - firsts.begin()), part.factor});
            if (found == firsts.end()) firsts.push_back(part.first);
        }
    }
    first_part.push_back(static_cast<int>(parts.size()));
}

ANCF_INLINE LocalCoordinates::LocalCoordinates(const Layout& layout, const Dependence& dependence,
                                               const Coupling& coupling, const char* what)
    : dimension_(layout.dimension()) {
    List<int> firsts;
    bool attached = false;
    for (const NodeField& at : coupling) {
        const int first = layout.index(at);
        require(first >= 0, "a ", what, " acts on ", to_string(at.field), " of node ",
                at.node.index, ", which carries no such vector: no element there has one",
                at.field == Field::r ? ", and no mass" : "");
        for (int k = 0; k < dimension_; ++k) read_.push_back(first + k);
        firsts.push_back(first);
        attached = attached || dependence.attached(first);
    }
    if (!attached) {
        acted_ = read_;
        return;
    }
    followed_ = FollowedVectors(dependence, firsts);
    for (const int first : followed_.firsts)
        for (int k = 0; k < dimension_; ++k) acted_.push_back(first + k);
}

/// Adds what stands for each of its own vectors, `width` numbers, to what it follows.
/// @param width  an int, or a constant of that type
template <class Width>
void multiply(const FollowedVectors& vectors, const double* from, Width width, double* out) {
    for (std::size_t own = 0; own + 1 < vectors.first_part.size(); ++own) {
        for (int k = vectors.first_part[own]; k < vectors.first_part[own + 1]; ++k) {
            const FollowedVectors::Part& part = vectors.parts[k];
            double* const to = out + part.vector * width;
            for (int i = 0; i < width; ++i) to[i] += part.factor * from[i];
        }
        from += width;
    }
}

ANCF_INLINE void LocalCoordinates::carry(VectorX& force) const {
    if (followed_.parts.empty()) return;
    VectorX carried = VectorX::Zero(static_cast<Eigen::Index>(acted_.size()));
    multiply(followed_, force.data(), dimension_, carried.data());
    force.swap(carried);
}

ANCF_INLINE void LocalCoordinates::carry_columns(MatrixX& derivatives) const {
    if (followed_.parts.empty() || derivatives.size() == 0) return;
    const auto rows = static_cast<int>(derivatives.rows());
    MatrixX carried;
    carried.setZero(rows, static_cast<Eigen::Index>(acted_.size()));
    multiply(followed_, derivatives.data(), rows * dimension_, carried.data());
    derivatives.swap(carried);
}

ANCF_INLINE void LocalCoordinates::carry(MatrixX& stiffness) const {
    if (followed_.parts.empty() || stiffness.size() == 0) return;
    carry_columns(stiffness);
    const auto size = static_cast<Eigen::Index>(acted_.size());
    MatrixX carried;
    carried.setZero(size, size);
    for (Eigen::Index j = 0; j < size; ++j)
        multiply(followed_, stiffness.col(j).data(), dimension_, carried.col(j).data());
    stiffness.swap(carried);
}

ANCF_INLINE const List<int>& LocalCoordinates::carry(MatrixX& stiffness, List<int>& active) const {
    if (!active.empty() && followed_.parts.empty()) {
        for (int& coordinate : active) coordinate = read_[coordinate];
        return active;
    }
    if (!active.empty()) {
        const auto size = static_cast<Eigen::Index>(read_.size());
        MatrixX whole = MatrixX::Zero(size, size);
        for (Eigen::Index j = 0; j < stiffness.cols(); ++j)
            for (Eigen::Index i = 0; i < stiffness.rows(); ++i)
                whole(active[i], active[j]) = stiffness(i, j);
        stiffness.swap(whole);
    }
    carry(stiffness);
    return acted_;
}

/// Returns the first coordinates of the vectors of an element.
[[nodiscard]] ANCF_INLINE List<int> vectors_of(const Layout& layout, Fields fields,
                                               const std::array<int, 2>& nodes) {
    List<int> firsts;
    for (const int node : nodes)
        for (int k = 0; k < fields.count(); ++k)
            firsts.push_back(layout.index({{node}, fields.at(k)}));
    return firsts;
}

ANCF_INLINE AttachedElement::AttachedElement(const Layout& layout, const Dependence& dependence,
                                             Fields fields, const std::array<int, 2>& nodes)
    : vectors(dependence, vectors_of(layout, fields, nodes)) {
    for (const int first : vectors.firsts) {
        const auto found = std::find(blocks.begin(), blocks.end(), layout.node_of(first));
        block_of.push_back(static_cast<int>(found - blocks.begin()));
        if (found == blocks.end()) blocks.push_back(layout.node_of(first));
    }
    const std::size_t count = vectors.firsts.size();
    require(count <= static_cast<std::size_t>(most_vectors), "nodes ", nodes[0], " and ", nodes[1],
            " follow ", count, " vectors by attachments, expected at most ", most_vectors);
}

/// Adds T^T K T to the values of a system.
template <int Dimension>
void add_transformed(const AttachedElement& element, const GroupTarget& target,
                     const double* tangent) {
    constexpr int most = Dimension * AttachedElement::most_vectors;
    const FollowedVectors& vectors = element.vectors;
    const int rows = Dimension * (static_cast<int>(vectors.first_part.size()) - 1);
    const int count = static_cast<int>(vectors.firsts.size());
    const std::size_t blocks = element.blocks.size();
    int place[most];  // within the node's block, -1 where held
    for (int vector = 0; vector < count; ++vector) {
        const auto of = static_cast<std::size_t>(vector);
        const int node = element.blocks[element.block_of[of]];
        for (int i = 0; i < Dimension; ++i) {
            const int equation = target.equation[vectors.firsts[of] + i];
            place[vector * Dimension + i] = equation < 0 ? -1 : equation - target.first_row[node];
        }
    }
    double half[most * ElementGroup::max_dofs], column[most];
    std::fill_n(half, Dimension * count * rows, 0.0);
    multiply(vectors, tangent, Dimension * rows, half);  // K T in the columns of T
    for (int q = 0; q < Dimension * count; ++q) {
        const int own = place[q];
        if (own < 0) continue;
        std::fill_n(column, Dimension * count, 0.0);
        multiply(vectors, half + q * rows, std::integral_constant<int, Dimension>(), column);
        const int block = element.block_of[q / Dimension];
        const int offset = target.column_offset(element.blocks[block], own);
        for (int vector = 0; vector < count; ++vector) {
            const int other = element.block_of[vector];
            const int base = element.base[static_cast<std::size_t>(other) * blocks +
                                          static_cast<std::size_t>(block)];
            if (base < 0) continue;
            const int least = other == block && target.storage == Storage::lower ? own : 0;
            double* const values = target.values + base + offset;
            for (int i = 0; i < Dimension; ++i)
                if (const int row = place[vector * Dimension + i]; row >= least)
                    values[row] += column[vector * Dimension + i];
        }
    }
}

ANCF_INLINE void add_attached(const GroupTarget& target, int place, const double* tangent) {
    if (target.layout.dimension() == 3)
        add_transformed<3>(target.attached[place], target, tangent);
    else
        add_transformed<2>(target.attached[place], target, tangent);
}

}  // namespace detail

}  // namespace ancf
