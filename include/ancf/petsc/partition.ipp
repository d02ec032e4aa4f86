// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of partition.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/partition.hpp>

#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace ancf::petsc::detail {

/// Returns the process of each vertex of a graph, the same in every process.
/// @param shares  process r gives the edges from the vertices shares[r] to before shares[r + 1]
/// @param from    first vertex of each of these edges; an edge may come more than once
/// @param to      second vertex
[[nodiscard]] ANCF_INLINE std::vector<int> parts_of_graph(MPI_Comm comm, const std::string& prefix,
                                                          const std::vector<PetscInt>& shares,
                                                          std::vector<PetscInt> from,
                                                          std::vector<PetscInt> to) {
    const std::size_t rank = at(Session::rank(comm));
    const PetscInt own = shares[rank + 1] - shares[rank], all = shares.back();
    Handle<Mat> edges, graph;
    Handle<MatPartitioning> method;
    Handle<IS> found, gathered;
    check(MatCreate(comm, edges.fresh()));
    check(MatSetSizes(edges, own, own, all, all));
    check(MatSetType(edges, MATAIJ));
    check(MatSetPreallocationCOO(edges, static_cast<PetscCount>(from.size()), from.data(),
                                 to.data()));
    check(MatSetValuesCOO(edges, std::vector<double>(from.size(), 1.0).data(), INSERT_VALUES));
    check(MatConvert(edges, MATMPIADJ, MAT_INITIAL_MATRIX, graph.fresh()));
    check(MatPartitioningCreate(comm, method.fresh()));
    check(MatPartitioningSetAdjacency(method, graph));
#if defined(PETSC_HAVE_PTSCOTCH)
    check(MatPartitioningSetType(method, MATPARTITIONINGPTSCOTCH));
#endif
    check(PetscObjectSetOptionsPrefix(reinterpret_cast<PetscObject>(MatPartitioning(method)),
                                      prefix.c_str()));
    check(MatPartitioningSetFromOptions(method));
    check(MatPartitioningApply(method, found.fresh()));
    check(ISAllGather(found, gathered.fresh()));
    const PetscInt* part = nullptr;
    check(ISGetIndices(gathered, &part));
    std::vector<int> parts(part, part + all);
    check(ISRestoreIndices(gathered, &part));
    return parts;
}

/// Who has what of a scene, the same in every process.
struct Division {
    std::vector<int> follows;      // the node that each node is attached to, -1
    std::vector<int> node;         // process of each node; -1 without vectors
    std::vector<int> constraint;   // process of each
    std::vector<char> eliminated;  // of each node: attached, and seen by one element alone

    Division(const Scene& whole, MPI_Comm comm, const std::string& prefix)
        : follows(at(whole.nodes()), -1), node(follows.size(), -1), eliminated(follows.size(), 0) {
        for (const AttachedVector& attachment : whole.attachments())
            follows[at(attachment.vector.node.index)] = attachment.to.index;
        divide(whole, comm, prefix);
        for (const auto& group : whole.groups())
            for (const Connection& c : group->connections)
                for (const NodeId end : {c.first, c.second})
                    if (int& of = node[at(end.index)]; of < 0) of = owner(c);
        for (int k = 0; k < whole.nodes(); ++k)
            if (int& of = node[at(k)]; of < 0 && whole.layout().size(k) > 0)
                of = node[at(leader({k}))];
        for (const AnyConstraint& each : whole.constraints())
            constraint.push_back(owner(each.coupling()));
        eliminate(whole);
    }

    /// Returns the node that stands for one: itself, or that at the end of its attachments.
    [[nodiscard]] int leader(NodeId of) const {
        int k = of.index;
        while (follows[at(k)] >= 0) k = follows[at(k)];
        return k;
    }
    [[nodiscard]] int owner(const Connection& c) const { return node[at(leader(c.first))]; }
    /// What couples nodes is where its first one is.
    [[nodiscard]] int owner(const Coupling& coupling) const {
        return coupling.empty() ? 0 : node[at(coupling.front().node.index)];
    }

private:
    void divide(const Scene& whole, MPI_Comm comm, const std::string& prefix) {
        std::vector<int> vertex(node.size(), -1), leaders;
        for (int k = 0; k < whole.nodes(); ++k)
            if (whole.layout().size(k) > 0 && follows[at(k)] < 0) {
                vertex[at(k)] = static_cast<int>(leaders.size());
                leaders.push_back(k);
            }
        const auto count = static_cast<long>(leaders.size());
        const int rank = Session::rank(comm), ranks = Session::ranks(comm);
        std::vector<PetscInt> shares = {0};
        std::vector<int> parts;
        for (int r = 0; r < ranks; ++r) {
            shares.push_back(static_cast<PetscInt>((r + 1) * count / ranks));
            parts.resize(at(shares.back()), r);
        }
        if (ranks > 1 && count >= 16L * ranks) {
            std::vector<PetscInt> from, to;
            const auto append = [&](PetscInt a, PetscInt b) {
                if (a < shares[at(rank)] || a >= shares[at(rank) + 1]) return;
                from.push_back(a);
                to.push_back(b);
            };
            for (const auto& group : whole.groups())
                for (const Connection& c : group->connections) {
                    const int a = vertex[at(leader(c.first))], b = vertex[at(leader(c.second))];
                    append(a, b);
                    append(b, a);
                }
            parts = parts_of_graph(comm, prefix, shares, std::move(from), std::move(to));
        }
        for (std::size_t k = 0; k < leaders.size(); ++k) node[at(leaders[k])] = parts[k];
    }

    void eliminate(const Scene& whole) {
        std::vector<int> seen(node.size(), 0);
        const auto see = [&](NodeId of) { seen[at(of.index)] += 1; };
        const auto see_all = [&](const Coupling& coupling) {
            for (const NodeField& vector : coupling) see(vector.node);
        };
        for (const auto& group : whole.groups())
            for (const Connection& c : group->connections) {
                see(c.first);
                if (c.second != c.first) see(c.second);
            }
        for (const ScaledLoad& load : whole.loads())
            if (!load.load.constant()) see_all(load.load.coupling());
        for (const AnyConstraint& each : whole.constraints()) see_all(each.coupling());
        for (const AttachedVector& attachment : whole.attachments()) see(attachment.to);
        for (std::size_t k = 0; k < node.size(); ++k)
            eliminated[k] = follows[k] >= 0 && seen[k] == 1;
    }
};

ANCF_INLINE Partition::Partition(const Scene& whole, MPI_Comm comm, const std::string& prefix)
    : whole_(whole), comm_(comm) {
    const QuietErrors quiet;
    const Division division(whole, comm, prefix);
    hold(division);
    number(division);
}

ANCF_INLINE Partition::~Partition() = default;

ANCF_INLINE void Partition::hold(const Division& division) {
    const int rank = Session::rank(comm_);
    held_.nodes.assign(division.node.size(), 0);
    const auto take = [&](NodeId of) {  // with those that it follows
        for (int k = of.index; k >= 0; k = division.follows[at(k)]) held_.nodes[at(k)] = 1;
    };
    const auto takes = [&](const Coupling& coupling) {
        if (division.owner(coupling) != rank) return false;
        for (const NodeField& vector : coupling) take(vector.node);
        return true;
    };
    for (int node = 0; node < whole_.nodes(); ++node)
        if (division.node[at(node)] == rank) take({node});
    for (const auto& group : whole_.groups()) {
        std::vector<int>& elements = held_.elements.emplace_back();
        for (int k = 0; k < group->size(); ++k) {
            const Connection& c = group->connections[at(k)];
            if (division.owner(c) != rank) continue;
            elements.push_back(k);
            take(c.first);
            take(c.second);
        }
    }
    for (std::size_t k = 0; k < whole_.loads().size(); ++k)
        if (takes(whole_.loads()[k].load.coupling())) held_.loads.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < whole_.constraints().size(); ++k)
        if (takes(whole_.constraints()[k].coupling()))
            held_.constraints.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < whole_.masses().size(); ++k)
        if (division.node[at(whole_.masses()[k].node.index)] == rank)
            held_.masses.push_back(static_cast<int>(k));
}

ANCF_INLINE void Partition::number(const Division& division) {
    const Layout& layout = whole_.layout();
    const Numbering numbering(whole_);
    int least = std::numeric_limits<int>::max(), most = 0;  // coordinates of a node with rows
    for (int node = 0; node < layout.nodes(); ++node)
        if (numbering.block_sizes()[at(node)] > 0 && division.eliminated[at(node)] == 0) {
            least = std::min(least, layout.size(node));
            most = std::max(most, layout.size(node));
        }
    const bool alike = least == most;
    own_rows_.block = !whole_.constraints().empty() ? 1 : alike ? most : layout.dimension();

    // each process numbers what it owns: coordinates, and rows behind those of the ranks before
    const int rank = Session::rank(comm_), ranks = Session::ranks(comm_);
    std::vector<PetscInt> coordinates(at(ranks) + 1, 0), rows = coordinates;  // of rank r at r + 1
    std::vector<PetscInt> first(division.node.size()), row(at(layout.size()), -1), constraint_row;
    for (int node = 0; node < layout.nodes(); ++node) {
        const std::size_t of = at(division.node[at(node)] + 1);
        first[at(node)] = std::exchange(coordinates[of], coordinates[of] + layout.size(node));
        if (division.eliminated[at(node)] != 0) continue;
        const int end = layout.first(node + 1);
        for (int k = layout.first(node), next = k; k < end; k = next) {
            next = std::min(k + own_rows_.block, end);
            const int* const equation = numbering.equations();
            if (std::any_of(equation + k, equation + next, [](int e) { return e >= 0; }))
                for (; k < next; ++k) row[at(k)] = rows[of]++;
        }
    }
    for (std::size_t k = 0; k < division.constraint.size(); ++k) {
        PetscInt& next = rows[at(division.constraint[k]) + 1];
        constraint_row.push_back(std::exchange(next, next + whole_.constraints()[k].equations()));
    }
    std::partial_sum(rows.begin(), rows.end(), rows.begin());
    own_rows_.first = rows[at(rank)];
    own_rows_.last = rows[at(rank) + 1];

    std::vector<PetscSFNode> roots;
    for (int node = 0; node < layout.nodes(); ++node) {
        if (held_.nodes[at(node)] == 0) continue;
        const int owner = division.node[at(node)];
        for (int k = 0; k < layout.size(node); ++k) {
            const int place = layout.first(node) + k;
            PetscInt& of = row[at(place)];
            if (of >= 0) of += rows[at(owner)];
            coordinates_.push_back({place, of, owner == rank});
            roots.push_back({owner, first[at(node)] + k});
        }
    }
    int place = 0;
    for (std::size_t k = 0; k < division.constraint.size(); ++k)
        for (int i = 0; i < whole_.constraints()[k].equations(); ++i, ++place)
            if (division.constraint[k] == rank)
                multipliers_.push_back({place, own_rows_.first + constraint_row[k] + i, true});
    sums_.resize(at(coordinates[at(rank) + 1]));
    if (ranks == 1) return;
    check(PetscSFCreate(comm_, shared_.fresh()));
    check(PetscSFSetGraph(shared_, static_cast<PetscInt>(sums_.size()),
                          static_cast<PetscInt>(roots.size()), nullptr, PETSC_COPY_VALUES,
                          roots.data(), PETSC_COPY_VALUES));
}

ANCF_INLINE int Partition::number_in_part(const ElementGroup& group, int element) const {
    std::size_t k = 0;
    while (k < held_.elements.size() && whole_.groups()[k].get() != &group) ++k;
    ancf::detail::require(k < held_.elements.size(),
                          "petsc: the scene had no element of this type when it was divided");
    const std::vector<int>& own = held_.elements[k];
    const auto found = std::lower_bound(own.begin(), own.end(), element);
    return found != own.end() && *found == element ? static_cast<int>(found - own.begin()) : -1;
}

ANCF_INLINE void Partition::add(VectorX& forces) const {
    if (shared_ == nullptr) return;
    const QuietErrors quiet;
    std::fill(sums_.begin(), sums_.end(), 0.0);
    check(PetscSFReduceBegin(shared_, MPIU_SCALAR, forces.data(), sums_.data(), MPI_SUM));
    check(PetscSFReduceEnd(shared_, MPIU_SCALAR, forces.data(), sums_.data(), MPI_SUM));
    check(PetscSFBcastBegin(shared_, MPIU_SCALAR, sums_.data(), forces.data(), MPI_REPLACE));
    check(PetscSFBcastEnd(shared_, MPIU_SCALAR, sums_.data(), forces.data(), MPI_REPLACE));
}

ANCF_INLINE void Partition::sum(double* values, int count) const {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm_);
}

ANCF_INLINE double Partition::largest(double value) const {
    if (std::isnan(value)) value = HUGE_VAL;  // more than any number
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
    return value;
}

ANCF_INLINE VectorX Partition::gather(const VectorX& of_part) const {
    ancf::detail::require(at(static_cast<PetscInt>(of_part.size())) == coordinates_.size(),
                          "Partition::gather: expected ", coordinates_.size(), " coordinates, got ",
                          of_part.size());
    return gather(of_part, coordinates_, whole_.layout().size());
}

ANCF_INLINE VectorX Partition::gather_multipliers(const VectorX& of_part) const {
    return gather(of_part, multipliers_, static_cast<int>(whole_.state().multipliers.size()));
}

ANCF_INLINE VectorX Partition::gather(const VectorX& of_part, const std::vector<Entry>& entries,
                                      int size) const {
    VectorX all = VectorX::Zero(size);
    for (std::size_t k = 0; k < entries.size(); ++k)
        if (entries[k].own) all[entries[k].place] = of_part[static_cast<Eigen::Index>(k)];
    sum(all.data(), size);
    return all;
}

ANCF_INLINE Rows Partition::rows(const Scene& part, const Numbering& numbering) const {
    Rows rows = own_rows_;
    for (int k = 0; k < numbering.coordinates(); ++k)
        if (numbering.equation(k) >= 0) rows.row.push_back(coordinates_[at(k)].row);
    for (const Entry& multiplier : multipliers_) rows.row.push_back(multiplier.row);
    std::vector<char> idle(at(rows.last - rows.first), 1);
    for (const PetscInt row : rows.row)
        if (rows.own(row)) idle[at(row - rows.first)] = 0;
    for (PetscInt row = rows.first; row < rows.last; ++row)
        if (idle[at(row - rows.first)] != 0) rows.idle.push_back(row);
    for (const auto& group : part.groups())
        for (const Connection& c : group->connections) {
            std::vector<int> set;
            for (const NodeId node : {c.first, c.second})
                for (int k = part.layout().first(node.index);
                     k < part.layout().first(node.index + 1); ++k)
                    if (const int e = numbering.equation(k); e >= 0 && rows.row[at(e)] < 0)
                        set.push_back(e);
            std::sort(set.begin(), set.end());
            set.erase(std::unique(set.begin(), set.end()), set.end());
            if (!set.empty()) rows.sets.push_back(std::move(set));
        }
    return rows;
}

}  // namespace ancf::petsc::detail
