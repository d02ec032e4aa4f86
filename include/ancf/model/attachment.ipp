// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of attachment.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/attachment.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace ancf {

ANCF_INLINE Dependence::Dependence(const Layout& layout,
                                   const std::vector<AttachedVector>& attachments)
    : dimension_(layout.dimension()) {
    if (attachments.empty()) return;
    vector_of_.assign(static_cast<std::size_t>(layout.size()), -1);
    for (const AttachedVector& attachment : attachments) {
        const int first = layout.index(attachment.vector);
        for (int k = 0; k < dimension_; ++k)
            vector_of_[static_cast<std::size_t>(first + k)] = static_cast<int>(firsts_.size());
        firsts_.push_back(first);
        std::vector<Part>& parts = parts_.emplace_back();
        for (std::size_t k = 0; k < attachment.factors.size(); ++k)
            if (attachment.factors[k] != 0.0)
                parts.push_back(
                    {layout.index({attachment.to, static_cast<Field>(k)}), attachment.factors[k]});
    }
    // chains: a part that is attached itself gives way to its own parts
    for (bool resolved = false; !resolved;) {
        resolved = true;
        for (std::vector<Part>& parts : parts_) {
            std::vector<Part> direct;
            for (const Part& part : parts)
                for (const Part& of : this->parts(part.first)) {
                    resolved = resolved && of.first == part.first;
                    const auto same =
                        std::find_if(direct.begin(), direct.end(),
                                     [&](const Part& other) { return other.first == of.first; });
                    if (same == direct.end())
                        direct.push_back({of.first, part.factor * of.factor});
                    else
                        same->factor += part.factor * of.factor;
                }
            parts = direct;
        }
    }
    for (std::size_t k = 0; k < parts_.size(); ++k)
        for (const Part& part : parts_[k]) followers_.emplace_back(part.first, k);
    std::sort(followers_.begin(), followers_.end());
}

ANCF_INLINE std::vector<Dependence::Part> Dependence::parts(int first) const {
    if (!attached(first)) return {{first, 1.0}};
    return parts_[static_cast<std::size_t>(vector_of_[static_cast<std::size_t>(first)])];
}

ANCF_INLINE void Dependence::complete(VectorX& coordinates) const {
    for (std::size_t k = 0; k < firsts_.size(); ++k) complete_one(coordinates, k);
}

ANCF_INLINE void Dependence::complete(VectorX& coordinates, int first) const {
    auto of = std::lower_bound(followers_.begin(), followers_.end(),
                               std::pair<int, std::size_t>(first, 0));
    for (; of != followers_.end() && of->first == first; ++of)
        complete_one(coordinates, of->second);
}

ANCF_INLINE void Dependence::complete_one(VectorX& coordinates, std::size_t attached) const {
    for (int i = 0; i < dimension_; ++i) {
        double sum = 0.0;
        for (const Part& part : parts_[attached]) sum += part.factor * coordinates[part.first + i];
        coordinates[firsts_[attached] + i] = sum;
    }
}

ANCF_INLINE void Dependence::carry(VectorX& forces) const {
    for (std::size_t k = 0; k < firsts_.size(); ++k)
        for (int i = 0; i < dimension_; ++i) {
            double& force = forces[firsts_[k] + i];
            for (const Part& part : parts_[k]) forces[part.first + i] += part.factor * force;
            force = 0.0;
        }
}

namespace detail {

ANCF_INLINE LocalCoordinates::LocalCoordinates(const Layout& layout, const Dependence& dependence,
                                               const Coupling& coupling, const char* what) {
    const int dimension = layout.dimension();
    bool attached = false;
    for (const NodeField& at : coupling) {
        const int first = layout.index(at);
        require(first >= 0, "a ", what, " acts on ", to_string(at.field), " of node ",
                at.node.index, ", which carries no such vector: no element there has one");
        for (int k = 0; k < dimension; ++k) read_.push_back(first + k);
        attached = attached || dependence.attached(first);
    }
    if (!attached) {
        acted_ = read_;
        return;
    }
    for (std::size_t row = 0; row < read_.size(); row += static_cast<std::size_t>(dimension))
        for (const Dependence::Part& part : dependence.parts(read_[row]))
            for (int k = 0; k < dimension; ++k) {
                auto found = std::find(acted_.begin(), acted_.end(), part.first + k);
                if (found == acted_.end()) found = acted_.insert(found, part.first + k);
                transfer_.push_back({static_cast<int>(row) + k,
                                     static_cast<int>(found - acted_.begin()), part.factor});
            }
}

ANCF_INLINE void LocalCoordinates::carry(VectorX& force) const {
    if (transfer_.empty()) return;
    VectorX carried = VectorX::Zero(static_cast<Eigen::Index>(acted_.size()));
    for (const Entry& entry : transfer_) carried[entry.acted] += entry.factor * force[entry.read];
    force.swap(carried);
}

ANCF_INLINE void LocalCoordinates::carry_columns(MatrixX& derivatives) const {
    if (transfer_.empty() || derivatives.size() == 0) return;
    const Eigen::Index rows = derivatives.rows();
    MatrixX carried = MatrixX::Zero(rows, static_cast<Eigen::Index>(acted_.size()));
    for (const Entry& entry : transfer_) {
        const double* const from = derivatives.data() + rows * entry.read;
        double* const to = carried.data() + rows * entry.acted;
        for (Eigen::Index i = 0; i < rows; ++i) to[i] += entry.factor * from[i];
    }
    derivatives.swap(carried);
}

ANCF_INLINE void LocalCoordinates::carry(MatrixX& stiffness) const {
    if (transfer_.empty() || stiffness.size() == 0) return;
    carry_columns(stiffness);
    const auto size = static_cast<Eigen::Index>(acted_.size());
    MatrixX carried = MatrixX::Zero(size, size);
    for (Eigen::Index j = 0; j < size; ++j)
        for (const Entry& entry : transfer_)
            carried(entry.acted, j) += entry.factor * stiffness(entry.read, j);
    stiffness.swap(carried);
}

ANCF_INLINE AttachedElement::AttachedElement(const Layout& layout, const Dependence& dependence,
                                             Fields fields, const std::array<int, 2>& nodes) {
    const auto place_of_block = [&](int node) {
        const auto found = std::find(blocks.begin(), blocks.end(), node);
        if (found != blocks.end()) return static_cast<int>(found - blocks.begin());
        blocks.push_back(node);
        return static_cast<int>(blocks.size()) - 1;
    };
    for (const int node : nodes)
        for (int k = 0; k < fields.count(); ++k) {
            first_part.push_back(static_cast<int>(parts.size()));
            for (const Dependence::Part& part :
                 dependence.parts(layout.index({{node}, fields.at(k)}))) {
                auto found = std::find_if(vectors.begin(), vectors.end(), [&](const Target& other) {
                    return other.first == part.first;
                });
                if (found == vectors.end())
                    found = vectors.insert(
                        found, {part.first, place_of_block(layout.node_of(part.first))});
                parts.push_back({static_cast<int>(found - vectors.begin()), part.factor});
            }
        }
    first_part.push_back(static_cast<int>(parts.size()));
    require(vectors.size() <= static_cast<std::size_t>(most_vectors), "nodes ", nodes[0], " and ",
            nodes[1], " follow ", vectors.size(), " vectors by attachments, expected at most ",
            most_vectors);
}

ANCF_INLINE void AttachedElement::add(const GroupTarget& target, const double* tangent) const {
    const int dimension = target.layout.dimension();
    const int own = dimension * (static_cast<int>(first_part.size()) - 1);
    const int size = dimension * static_cast<int>(vectors.size());
    double half[9 * most_vectors * most_vectors], whole[9 * most_vectors * most_vectors];
    // out(:, p) = sum of factor times in(:, j) over the parts p of j; by rows of length `rows`
    const auto combine = [&](const double* in, int rows, double* out) {
        std::fill_n(out, rows * size, 0.0);
        for (std::size_t vector = 0; vector + 1 < first_part.size(); ++vector)
            for (int k = first_part[vector]; k < first_part[vector + 1]; ++k) {
                const Part& part = parts[static_cast<std::size_t>(k)];
                const double* from = in + static_cast<int>(vector) * dimension * rows;
                double* to = out + part.vector * dimension * rows;
                for (int i = 0; i < dimension * rows; ++i) to[i] += part.factor * from[i];
            }
    };
    const auto transpose = [](const double* in, int rows, int columns, double* out) {
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < rows; ++i) out[i * columns + j] = in[j * rows + i];
    };
    combine(tangent, own, half);  // K T
    transpose(half, own, size, whole);
    combine(whole, size, half);  // T^T K^T T
    const std::size_t count = blocks.size();
    for (int q = 0; q < size; ++q) {
        const Target& column = vectors[static_cast<std::size_t>(q / dimension)];
        const int equation = target.equation[column.first + q % dimension];
        if (equation < 0) continue;
        const int node = blocks[static_cast<std::size_t>(column.block)];
        const int place = equation - target.first_row[node];
        for (int p = 0; p < size; ++p) {
            const Target& row = vectors[static_cast<std::size_t>(p / dimension)];
            const int other = target.equation[row.first + p % dimension];
            if (other < 0 || (target.storage == Storage::lower && other < equation)) continue;
            const int from = base[static_cast<std::size_t>(row.block) * count +
                                  static_cast<std::size_t>(column.block)];
            const int top = target.first_row[blocks[static_cast<std::size_t>(row.block)]];
            target.values[from + target.column_offset(node, place) + other - top] +=
                half[q + p * size];
        }
    }
}

ANCF_INLINE void add_attached(const GroupTarget& target, int place, const double* tangent) {
    target.attached[place].add(target, tangent);
}

}  // namespace detail

}  // namespace ancf
