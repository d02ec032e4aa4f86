// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of partition.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/errors.hpp>
#include <ancf/petsc/partition.hpp>

#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::petsc::detail {

/// Returns the part of each vertex of a graph, the same in every process.
/// @param edges  of this process's share of the vertices, both ways, sorted by the first
[[nodiscard]] ANCF_INLINE std::vector<int> parts_of_graph(
    MPI_Comm comm, const std::string& prefix, const std::vector<int>& shares,
    const std::vector<std::pair<int, int>>& edges) {
    const int first = shares[at(rank_in(comm))], last = shares[at(rank_in(comm)) + 1];
    PetscInt *ia = nullptr, *ja = nullptr;  // the matrix takes them over
    check(PetscMalloc1(static_cast<std::size_t>(last - first) + 1, &ia));
    check(PetscMalloc1(edges.size(), &ja));
    std::size_t k = 0;
    for (int vertex = first; vertex < last; ++vertex) {
        ia[vertex - first] = static_cast<PetscInt>(k);
        for (; k < edges.size() && edges[k].first == vertex; ++k) ja[k] = edges[k].second;
    }
    ia[last - first] = static_cast<PetscInt>(k);
    Handle<Mat> graph;
    Handle<MatPartitioning> method;
    Handle<IS> found;
    check(MatCreateMPIAdj(comm, last - first, shares.back(), ia, ja, nullptr, graph.fresh()));
    check(MatPartitioningCreate(comm, method.fresh()));
    check(MatPartitioningSetAdjacency(method, graph));
#if defined(PETSC_HAVE_PTSCOTCH)
    check(MatPartitioningSetType(method, MATPARTITIONINGPTSCOTCH));
#endif
    check(PetscObjectSetOptionsPrefix(reinterpret_cast<PetscObject>(MatPartitioning(method)),
                                      prefix.c_str()));
    check(MatPartitioningSetFromOptions(method));
    check(MatPartitioningApply(method, found.fresh()));
    const PetscInt* of = nullptr;
    check(ISGetIndices(found, &of));
    const std::vector<int> own(of, of + (last - first));
    check(ISRestoreIndices(found, &of));
    std::vector<int> all(at(shares.back())), counts;
    for (std::size_t r = 0; r + 1 < shares.size(); ++r) counts.push_back(shares[r + 1] - shares[r]);
    MPI_Allgatherv(own.data(), last - first, MPI_INT, all.data(), counts.data(), shares.data(),
                   MPI_INT, comm);
    return all;
}

ANCF_INLINE Partition::Partition(const Scene& whole, MPI_Comm comm, const std::string& prefix)
    : whole_(whole),
      comm_(comm),
      rank_(rank_in(comm)),
      ranks_(ranks_in(comm)),
      owner_(at(whole.nodes()), -1) {
    const QuietErrors quiet;
    follow();
    divide(prefix);
    assign_elements();
    eliminate();
    hold();
    number_rows();
    connect();
}

ANCF_INLINE Partition::~Partition() = default;

template <class Visitor>
void Partition::visit_all(int node, const Visitor& visit) const {
    visit(node);
    if (followed_.empty()) return;
    for (const int other : followed_[at(node)]) visit(other);
}

ANCF_INLINE void Partition::follow() {
    if (whole_.attachments().empty()) return;
    const Layout& layout = whole_.layout();
    followed_.resize(at(layout.nodes()));
    const auto append = [&](int from, int to) {
        std::vector<int>& of = followed_[at(from)];
        if (std::find(of.begin(), of.end(), to) == of.end()) of.push_back(to);
    };
    for (const AttachedVector& attachment : whole_.attachments()) {
        const int from = attachment.vector.node.index;
        for (const Dependence::Part& part :
             whole_.dependence().parts(layout.index(attachment.vector)))
            append(from, layout.node_of(part.first));
    }
    // nodes on the way to those that stand free come with them
    for (const AttachedVector& attachment : whole_.attachments())
        append(attachment.vector.node.index, attachment.to.index);
    for (std::vector<int>& of : followed_)
        for (std::size_t k = 0; k < of.size(); ++k) {
            const std::vector<int> further = followed_[at(of[k])];
            for (const int node : further)
                if (std::find(of.begin(), of.end(), node) == of.end()) of.push_back(node);
        }
}

ANCF_INLINE void Partition::divide(const std::string& prefix) {
    std::vector<int> vertex(owner_.size(), -1), nodes;
    for (int node = 0; node < whole_.nodes(); ++node)
        if (whole_.layout().size(node) > 0 && leader(node) == node) {
            vertex[at(node)] = static_cast<int>(nodes.size());
            nodes.push_back(node);
        }
    const auto count = static_cast<long>(nodes.size());
    std::vector<int> shares;
    for (long r = 0; r <= ranks_; ++r) shares.push_back(static_cast<int>(r * count / ranks_));
    std::vector<int> part(nodes.size());
    if (ranks_ == 1 || count < 16L * ranks_) {
        for (int r = 0; r < ranks_; ++r)
            std::fill(part.begin() + shares[at(r)], part.begin() + shares[at(r) + 1], r);
    } else {
        const int first = shares[at(rank_)], last = shares[at(rank_) + 1];
        std::vector<std::pair<int, int>> edges;
        std::vector<int> ends;
        for (const auto& group : whole_.groups())
            for (const Connection& c : group->connections) {
                ends.clear();
                for (const NodeId node : {c.first, c.second})
                    visit_all(node.index, [&](int k) {
                        if (vertex[at(k)] >= 0) ends.push_back(vertex[at(k)]);
                    });
                for (const int a : ends)
                    for (const int b : ends)
                        if (a != b && a >= first && a < last) edges.emplace_back(a, b);
            }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        part = parts_of_graph(comm_, prefix, shares, edges);
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) owner_[at(nodes[k])] = part[k];
}

ANCF_INLINE void Partition::assign_elements() {
    for (const auto& group : whole_.groups()) {
        std::vector<int>& own = held_.elements.emplace_back();
        for (int k = 0; k < group->size(); ++k) {
            const Connection& c = group->connections[at(k)];
            const int owner = owner_[at(leader(c.first.index))];
            if (owner == rank_) own.push_back(k);
            for (const NodeId node : {c.first, c.second})
                if (int& of = owner_[at(node.index)]; of < 0) of = owner;
        }
    }
    for (int node = 0; node < whole_.nodes(); ++node)
        if (int& of = owner_[at(node)]; of < 0 && whole_.layout().size(node) > 0)
            of = owner_[at(leader(node))];
}

// An attached node that one element alone sees.
ANCF_INLINE void Partition::eliminate() {
    eliminated_.assign(owner_.size(), 0);
    if (followed_.empty()) return;
    std::vector<int> seen(owner_.size(), 0);
    const auto see = [&](NodeId node) { seen[at(node.index)] += 1; };
    for (const auto& group : whole_.groups())
        for (const Connection& c : group->connections) {
            see(c.first);
            if (c.second != c.first) see(c.second);
        }
    for (const ScaledLoad& load : whole_.loads())
        if (!load.load.constant())
            for (const NodeField& vector : load.load.coupling()) see(vector.node);
    for (const AnyConstraint& constraint : whole_.constraints())
        for (const NodeField& vector : constraint.coupling()) see(vector.node);
    for (const AttachedVector& attachment : whole_.attachments()) see(attachment.to);
    for (std::size_t k = 0; k < owner_.size(); ++k)
        eliminated_[k] = !followed_[k].empty() && seen[k] == 1 ? 1 : 0;
}

ANCF_INLINE void Partition::hold() {
    held_.nodes.assign(owner_.size(), 0);
    const auto take = [&](int node) { visit_all(node, [&](int k) { held_.nodes[at(k)] = 1; }); };
    for (int node = 0; node < whole_.nodes(); ++node)
        if (owner_[at(node)] == rank_) take(node);
    for (std::size_t group = 0; group < held_.elements.size(); ++group)
        for (const int k : held_.elements[group]) {
            const Connection& c = whole_.groups()[group]->connections[at(k)];
            take(c.first.index);
            take(c.second.index);
        }
    // what couples nodes is where its first one is
    const auto owner_of = [&](const Coupling& coupling) {
        const int owner = coupling.empty() ? 0 : owner_[at(coupling.front().node.index)];
        if (owner == rank_)
            for (const NodeField& vector : coupling) take(vector.node.index);
        return owner;
    };
    for (std::size_t k = 0; k < whole_.loads().size(); ++k)
        if (owner_of(whole_.loads()[k].load.coupling()) == rank_)
            held_.loads.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < whole_.constraints().size(); ++k) {
        constraint_owner_.push_back(owner_of(whole_.constraints()[k].coupling()));
        if (constraint_owner_.back() == rank_) held_.constraints.push_back(static_cast<int>(k));
    }
    for (std::size_t k = 0; k < whole_.masses().size(); ++k)
        if (owner_[at(whole_.masses()[k].node.index)] == rank_)
            held_.masses.push_back(static_cast<int>(k));
}

ANCF_INLINE void Partition::number_rows() {
    const Layout& layout = whole_.layout();
    const Numbering numbering(whole_);
    const auto is_free = [&](int coordinate) { return numbering.equation(coordinate) >= 0; };
    const auto keeps = [&](int node) {
        return numbering.block_sizes()[at(node)] > 0 && eliminated_[at(node)] == 0;
    };
    if (whole_.constraints().empty()) {
        by_node_ = true;
        block_ = 0;
        for (int node = 0; node < layout.nodes() && by_node_; ++node) {
            if (!keeps(node)) continue;
            if (block_ == 0) block_ = layout.size(node);
            by_node_ = layout.size(node) == block_;
        }
        if (!by_node_ || block_ == 0) block_ = layout.dimension();
    }
    const auto rows_of = [&](int node) {
        if (by_node_) return block_;
        if (block_ == 1) return numbering.block_sizes()[at(node)];
        int vectors = 0;
        for (int at = layout.first(node); at < layout.first(node + 1); at += block_) {
            bool any = false;
            for (int k = 0; k < block_; ++k) any = any || is_free(at + k);
            vectors += any ? 1 : 0;
        }
        return vectors * block_;
    };
    std::vector<PetscInt> count(at(ranks_) + 1, 0);  // of the ranks before
    for (int node = 0; node < layout.nodes(); ++node)
        if (keeps(node)) count[at(owner_[at(node)]) + 1] += rows_of(node);
    for (std::size_t k = 0; k < constraint_owner_.size(); ++k)
        count[at(constraint_owner_[k]) + 1] += whole_.constraints()[k].equations();
    for (std::size_t r = 0; r + 1 < count.size(); ++r) count[r + 1] += count[r];
    first_row_ = count[at(rank_)];
    last_row_ = count[at(rank_) + 1];
    node_row_.assign(owner_.size(), -1);
    for (int node = 0; node < layout.nodes(); ++node)
        if (keeps(node)) {
            PetscInt& next = count[at(owner_[at(node)])];
            node_row_[at(node)] = next;
            next += rows_of(node);
        }
    for (std::size_t k = 0; k < constraint_owner_.size(); ++k) {
        PetscInt& next = count[at(constraint_owner_[k])];
        constraint_row_.push_back(next);
        next += whole_.constraints()[k].equations();
    }
}

// The coordinates that a process owns are roots, those at its rim leaves.
ANCF_INLINE void Partition::connect() {
    const Layout& layout = whole_.layout();
    std::vector<PetscInt> first(at(ranks_) + 1, 0), global(owner_.size(), -1);
    for (int node = 0; node < layout.nodes(); ++node)
        if (const int of = owner_[at(node)]; of >= 0) first[at(of) + 1] += layout.size(node);
    for (std::size_t r = 0; r + 1 < first.size(); ++r) first[r + 1] += first[r];
    const PetscInt all = first.back(), own = first[at(rank_) + 1] - first[at(rank_)];
    for (int node = 0; node < layout.nodes(); ++node)
        if (const int of = owner_[at(node)]; of >= 0) {
            global[at(node)] = first[at(of)];
            first[at(of)] += layout.size(node);
        }
    std::vector<PetscInt> remote;
    int next = 0;  // coordinate of the part
    for (int node = 0; node < layout.nodes(); ++node) {
        if (held_.nodes[at(node)] == 0) continue;
        const bool mine = owner_[at(node)] == rank_;
        for (int k = 0; k < layout.size(node); ++k, ++next) {
            own_.push_back(mine ? 1 : 0);
            (mine ? mine_ : rim_).push_back(next);
            if (!mine) remote.push_back(global[at(node)] + k);
        }
    }
    roots_.resize(mine_.size());
    leaves_.resize(rim_.size());
    if (ranks_ == 1) return;
    PetscLayout order = nullptr;
    check(PetscLayoutCreateFromSizes(comm_, own, all, 1, &order));
    check(PetscSFCreate(comm_, shared_.fresh()));
    check(PetscSFSetGraphLayout(shared_, order, static_cast<PetscInt>(remote.size()), nullptr,
                                PETSC_COPY_VALUES, remote.data()));
    check(PetscLayoutDestroy(&order));
}

ANCF_INLINE int Partition::number_in_part(const ElementGroup& group, int element) const {
    std::size_t at = 0;
    while (at < held_.elements.size() && whole_.groups()[at].get() != &group) ++at;
    ancf::detail::require(at < held_.elements.size(),
                          "petsc: the scene had no element of this type when it was divided");
    const std::vector<int>& own = held_.elements[at];
    const auto found = std::lower_bound(own.begin(), own.end(), element);
    return found != own.end() && *found == element ? static_cast<int>(found - own.begin()) : -1;
}

ANCF_INLINE void Partition::add(VectorX& forces) const {
    if (shared_ == nullptr) return;
    const QuietErrors quiet;
    for (std::size_t k = 0; k < mine_.size(); ++k) roots_[k] = forces[mine_[k]];
    for (std::size_t k = 0; k < rim_.size(); ++k) leaves_[k] = forces[rim_[k]];
    check(PetscSFReduceBegin(shared_, MPIU_SCALAR, leaves_.data(), roots_.data(), MPI_SUM));
    check(PetscSFReduceEnd(shared_, MPIU_SCALAR, leaves_.data(), roots_.data(), MPI_SUM));
    check(PetscSFBcastBegin(shared_, MPIU_SCALAR, roots_.data(), leaves_.data(), MPI_REPLACE));
    check(PetscSFBcastEnd(shared_, MPIU_SCALAR, roots_.data(), leaves_.data(), MPI_REPLACE));
    for (std::size_t k = 0; k < mine_.size(); ++k) forces[mine_[k]] = roots_[k];
    for (std::size_t k = 0; k < rim_.size(); ++k) forces[rim_[k]] = leaves_[k];
}

ANCF_INLINE void Partition::sum(double* values, int count) const {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm_);
}

ANCF_INLINE double Partition::largest(double value) const {
    // a NaN counts as more than any number
    if (value != value) value = HUGE_VAL;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
    return value;
}

ANCF_INLINE VectorX Partition::gather(const VectorX& of_part) const {
    const Layout& layout = whole_.layout();
    ancf::detail::require(of_part.size() == static_cast<Eigen::Index>(own_.size()),
                          "Partition::gather: expected ", own_.size(), " coordinates, got ",
                          of_part.size());
    VectorX all = VectorX::Zero(layout.size());
    Eigen::Index next = 0;
    for (int node = 0; node < layout.nodes(); ++node) {
        if (held_.nodes[at(node)] == 0) continue;
        for (int k = layout.first(node); k < layout.first(node + 1); ++k, ++next)
            if (owner_[at(node)] == rank_) all[k] = of_part[next];
    }
    sum(all.data(), static_cast<int>(all.size()));
    return all;
}

ANCF_INLINE VectorX Partition::gather_multipliers(const VectorX& of_part) const {
    std::vector<double> all;
    Eigen::Index next = 0;
    for (std::size_t k = 0; k < constraint_owner_.size(); ++k)
        for (int i = 0; i < whole_.constraints()[k].equations(); ++i)
            all.push_back(constraint_owner_[k] == rank_ ? of_part[next++] : 0.0);
    sum(all.data(), static_cast<int>(all.size()));
    return Eigen::Map<const VectorX>(all.data(), static_cast<Eigen::Index>(all.size()));
}

ANCF_INLINE Partition::Rows Partition::rows(const Scene& part, const Numbering& numbering) const {
    const Layout& layout = part.layout();
    Rows rows;
    rows.row.reserve(at(numbering.unknowns()));
    std::vector<char> taken(static_cast<std::size_t>(last_row_ - first_row_), 0);
    const auto append = [&](PetscInt row) {
        const bool own = row >= first_row_ && row < last_row_;
        if (own) taken[static_cast<std::size_t>(row - first_row_)] = 1;
        rows.row.push_back(row);
        rows.own.push_back(own ? 1 : 0);
    };
    for (int node = 0; node < layout.nodes(); ++node) {
        const PetscInt first = node_row_[at(node)];
        PetscInt next = 0;  // of the node's rows so far
        const int step = by_node_ || block_ == 1 ? 1 : block_;
        for (int at = layout.first(node); at < layout.first(node + 1); at += step) {
            bool any = false;
            for (int k = 0; k < step; ++k) {
                if (numbering.equation(at + k) < 0) continue;
                any = true;
                append(first < 0 ? -1 : first + next + k);
            }
            if (any || by_node_) next += step;
        }
    }
    for (const int k : held_.constraints)
        for (int i = 0; i < whole_.constraints()[at(k)].equations(); ++i)
            append(constraint_row_[at(k)] + i);
    for (std::size_t k = 0; k < taken.size(); ++k)
        if (taken[k] == 0) rows.idle.push_back(first_row_ + static_cast<PetscInt>(k));
    if (followed_.empty()) return rows;
    for (const auto& group : part.groups())
        for (const Connection& c : group->connections) {
            std::vector<int> set;
            for (const int node : {c.first.index, c.second.index})
                if (eliminated_[at(node)] != 0)
                    for (int k = layout.first(node); k < layout.first(node + 1); ++k)
                        if (const int equation = numbering.equation(k); equation >= 0)
                            set.push_back(equation);
            std::sort(set.begin(), set.end());
            if (!set.empty()) rows.sets.push_back(std::move(set));
        }
    return rows;
}

}  // namespace ancf::petsc::detail
