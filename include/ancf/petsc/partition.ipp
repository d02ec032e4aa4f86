// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/partition.hpp>

#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::petsc::detail {

/// Returns the process of each vertex of a graph, the same in every process: fewer than 16 a
/// process in the order of their numbers. Every process has the whole graph.
[[nodiscard]] ANCF_INLINE List<int> parts_of_graph(MPI_Comm comm, const std::string& prefix,
                                                   int vertices,
                                                   const List<std::pair<int, int>>& edges) {
    const int rank = Session::rank(comm), ranks = Session::ranks(comm);
    std::vector<PetscInt> shares = {0};  // process r tells the edges from shares[r] to before r + 1
    List<int> parts;
    for (int r = 0; r < ranks; ++r) {
        shares.push_back(static_cast<PetscInt>((r + 1L) * vertices / ranks));
        parts.resize(shares.back(), r);
    }
    if (ranks == 1 || vertices < 16L * ranks) return parts;
    std::vector<PetscInt> from, to;
    const auto append = [&](PetscInt a, PetscInt b) {
        if (a == b || a < shares[rank] || a >= shares[rank + 1]) return;
        from.push_back(a);
        to.push_back(b);
    };
    for (const auto& [a, b] : edges) {
        append(a, b);
        append(b, a);
    }
    const PetscInt own = shares[rank + 1] - shares[rank];
    Handle<Mat> pattern, graph;
    Handle<MatPartitioning> method;
    Handle<IS> found, gathered;
    check(MatCreate(comm, pattern.fresh()));
    check(MatSetSizes(pattern, own, own, vertices, vertices));
    check(MatSetType(pattern, MATAIJ));
    check(MatSetPreallocationCOO(pattern, from.size(), from.data(), to.data()));
    check(MatSetValuesCOO(pattern, std::vector<double>(from.size(), 1.0).data(), INSERT_VALUES));
    check(MatConvert(pattern, MATMPIADJ, MAT_INITIAL_MATRIX, graph.fresh()));
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
    parts.assign(part, part + vertices);
    check(ISRestoreIndices(gathered, &part));
    return parts;
}

ANCF_INLINE Partition::Partition(const Scene& whole, MPI_Comm comm, const std::string& prefix)
    : whole_(whole),
      comm_(comm),
      division_(whole,
                [&](int vertices, const auto& edges) {
                    const QuietErrors quiet;
                    return parts_of_graph(comm, prefix, vertices, edges);
                }),
      rank_(Session::rank(comm)),
      held_(division_.held(whole, rank_)) {
    const QuietErrors quiet;
    const Layout& layout = whole_.layout();
    const int ranks = Session::ranks(comm_);
    std::vector<PetscInt> count(ranks, 0);  // coordinates that each process owns
    std::vector<PetscSFNode> roots;
    for (int node = 0; node < layout.nodes(); ++node)
        for (int k = 0; k < layout.size(node); ++k) {
            const int owner = division_.part[node];
            const PetscInt place = count[owner]++;
            if (held_.nodes[node] == 0) continue;
            own_.push_back(owner == rank_);
            roots.push_back({owner, place});
        }
    if (ranks == 1) return;
    sums_.resize(count[rank_]);
    check(PetscSFCreate(comm_, shared_.fresh()));
    check(PetscSFSetGraph(shared_, count[rank_], static_cast<PetscInt>(roots.size()), nullptr,
                          PETSC_COPY_VALUES, roots.data(), PETSC_COPY_VALUES));
}

ANCF_INLINE Partition::~Partition() = default;

ANCF_INLINE int Partition::number_in_part(const ElementGroup& group, int element) const {
    std::size_t k = 0;
    while (k < held_.elements.size() && whole_.groups()[k].get() != &group) ++k;
    ancf::detail::require(k < held_.elements.size(),
                          "petsc: the scene had no element of this type when it was divided");
    const List<int>& own = held_.elements[k];
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
    const Layout& layout = whole_.layout();
    const auto count = static_cast<Eigen::Index>(own_.size());
    ancf::detail::require(of_part.size() == count, "Partition::gather: expected ", count,
                          " coordinates, got ", of_part.size());
    VectorX all = VectorX::Zero(layout.size());
    int next = 0;
    for (int node = 0; node < layout.nodes(); ++node) {
        if (held_.nodes[node] == 0) continue;
        for (int k = layout.first(node); k < layout.first(node + 1); ++k, ++next)
            if (owns(next)) all[k] = of_part[next];
    }
    sum(all.data(), layout.size());
    return all;
}

ANCF_INLINE VectorX Partition::gather_multipliers(const VectorX& of_part) const {
    Eigen::Index count = 0;
    for (const AnyConstraint& each : constraints()) count += each.equations();
    VectorX all = VectorX::Zero(count);
    Eigen::Index place = 0, next = 0;
    for (const AnyConstraint& each : constraints()) {
        const bool own = division_.owner(each.coupling()) == rank_;
        for (int i = 0; i < each.equations(); ++i, ++place)
            if (own) all[place] = of_part[next++];
    }
    sum(all.data(), static_cast<int>(all.size()));
    return all;
}

ANCF_INLINE Rows Partition::rows(const Scene& part, const Numbering& numbering) const {
    const Layout& layout = part.layout();
    const int* const equation = numbering.equations();
    const auto any_free = [&](int from, int to) {
        return std::any_of(equation + from, equation + to, [](int e) { return e >= 0; });
    };
    std::vector<int> own;                 // nodes of this process with rows
    double most = 0.0, least = HUGE_VAL;  // coordinates of such a node
    for (int node = 0; node < layout.nodes(); ++node) {
        if (division_.part[node] != rank_ || division_.eliminated[node] != 0 ||
            !any_free(layout.first(node), layout.first(node + 1)))
            continue;
        own.push_back(node);
        most = std::max<double>(most, layout.size(node));
        least = std::min<double>(least, layout.size(node));
    }
    most = largest(most);
    const bool alike = most == -largest(-least);
    Rows rows;
    rows.block = !constraints().empty() ? 1 : alike ? static_cast<int>(most) : layout.dimension();

    // a block has rows where any of its coordinates is free; they count from 1, 0 is none
    VectorX number = VectorX::Zero(layout.size());
    PetscInt count = 0;
    for (const int node : own)
        for (int k = layout.first(node), end = layout.first(node + 1), next = k; k < end;
             k = next) {
            next = std::min(k + rows.block, end);
            if (!any_free(k, next)) continue;
            for (; k < next; ++k) {
                if (equation[k] < 0) rows.idle.push_back(count);
                number[k] = ++count;
            }
        }
    count += numbering.multipliers();
    MPI_Scan(&count, &rows.last, 1, MPIU_INT, MPI_SUM, comm_);
    rows.first = rows.last - count;
    for (PetscInt& idle : rows.idle) idle += rows.first;
    for (double& row : number) row += row > 0.0 ? rows.first : 0;
    add(number);
    for (int k = 0; k < layout.size(); ++k)
        if (equation[k] >= 0) rows.of_equation.push_back(static_cast<PetscInt>(number[k]) - 1);
    for (int k = numbering.multipliers(); k > 0; --k) rows.of_equation.push_back(rows.last - k);

    // unknowns of an element without rows are eliminated together
    for (const auto& group : part.groups())
        for (const Connection& c : group->connections) {
            List<int> set;
            for (const NodeId node : {c.first, c.second})
                for (int k = layout.first(node.index); k < layout.first(node.index + 1); ++k)
                    if (equation[k] >= 0 && number[k] == 0.0) set.push_back(equation[k]);
            std::sort(set.begin(), set.end());
            set.erase(std::unique(set.begin(), set.end()), set.end());
            if (!set.empty()) rows.sets.push_back(std::move(set));
        }
    return rows;
}

}  // namespace ancf::petsc::detail
