// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The evaluation of the cross-section beam in the plane.
///
/// Stations give derivatives by the vectors of the centre line and by nodal shears; slopes enter by
/// these shears and by the transverse strain alone.

#pragma once

#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/planar/nodal.hpp>
#include <ancf/element/planar/section.hpp>
#include <ancf/element/planar/station.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

/// A transverse strain of a node: gradient by the slope, 1/|a| of the stretch, conjugate.
template <class C>
struct TransverseTerm {
    C gradient[2];
    C inverse;
    C stress;  ///< nodal_conjugate()
};

/// Constant data of a planar element and its evaluation.
/// @tparam Layout  a PlanarLayout
template <class Measure, class Layout>
struct PlanarKernel {
    static constexpr int dimension = 2, dofs = Layout::dofs;
    template <class S>
    using Nodes = PlanarNodes<S, Layout>;

    List<PlanarStation<Layout>> stations;
    List<AxialStationData<double, Layout::line>> axial;
    double transverse_stiffness;     ///< of e_yy times the length, N m
    double transverse_length = 0.0;  ///< l, m, that the parameter of nodal rates runs through
    double
        transverse_reference[Layout::shears];  ///< nodal e_yy, and rates, of the stress-free state
    TransverseStrain transverse_measure = TransverseStrain::green;

    /// Makes e the stress-free state: its strains are the ones subtracted from now on.
    void set_reference(const Vector<double, dofs>& e) noexcept {
        const Nodes<double> nodes(e);
        for (PlanarStation<Layout>& station : stations) {
            PlanarFrame<double> f;
            planar_frame(station.shape, nodes, f);
            double strains[planar_strain_count];
            Measure::strains(f.w, strains);
            for (int k = 0; k < planar_strain_count; ++k) station.reference[k] = strains[k];
        }
        for (AxialStationData<double, Layout::line>& station : axial) {
            station.reference = 0.0;
            station.reference = planar_axial(station, nodes).strain;
        }
        Transverse<double> terms;
        for (double& reference : transverse_reference) reference = 0.0;
        double strains[Layout::shears];
        transverse_strains(nodes, terms, strains);
        for (int m = 0; m < Layout::shears; ++m) transverse_reference[m] = strains[m];
    }

    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept {
        const Nodes<S> nodes(e);
        PlanarSums<S, Layout> sums;
        walk<false>(nodes, sums);
        Transverse<S> transverse;
        return sums.energy + transverse_terms(nodes, transverse);
    }

    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept {
        const Nodes<S> nodes(e);
        PlanarSums<S, Layout> sums;
        walk<false>(nodes, sums);
        Transverse<S> transverse;
        (void)transverse_terms(nodes, transverse);
        return gradient(nodes, sums, transverse);
    }

    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        const Nodes<S> nodes(e);
        PlanarSums<S, Layout> sums;
        walk<true>(nodes, sums);
        Transverse<S> transverse;
        Evaluation<S, dofs> result;
        result.energy = sums.energy + transverse_terms(nodes, transverse);
        result.force = gradient(nodes, sums, transverse);
        write_tangent(nodes, sums, transverse, result.tangent);
        return result;
    }

    /// As LineElement::evaluate() of a state and the correction that led to it.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        const Nodes<S> nodes(e);
        PlanarSums<S, Layout> sums;
        walk<false>(nodes, sums);
        Transverse<S> transverse;
        MixedEvaluation<S, dofs> result;
        result.energy = sums.energy + transverse_terms(nodes, transverse);
        result.force = gradient(nodes, sums, transverse);

        const Nodes<Dual<S>> line(course(before, change));
        PlanarSums<S, Layout> predicted;
        for (const PlanarStation<Layout>& station : stations) {
            PlanarFrame<Dual<S>> frame;
            Dual<S> strains[planar_strain_count], course_stress[planar_strain_count];
            planar_state<Measure>(station, line, frame, strains, course_stress);
            S stress[planar_strain_count];
            for (int k = 0; k < planar_strain_count; ++k) stress[k] = arrived(course_stress[k]);
            add_planar_station<true, Measure>(station, nodes, predicted, stress);
        }
        for (const AxialStationData<double, Layout::line>& station : axial) {
            const S stress = arrived(planar_axial(station, line).stress);
            add_planar_axial<true>(station, nodes, predicted, &stress);
        }
        Transverse<Dual<S>> course_transverse;
        Dual<S> course_strain[Layout::shears], course_stress[Layout::shears];
        transverse_strains(line, course_transverse, course_strain);
        transverse_stresses(course_strain, course_stress);
        S stress[Layout::shears];
        for (int m = 0; m < Layout::shears; ++m) stress[m] = arrived(course_stress[m]);
        for (int node = 0; node < 2; ++node)
            transverse[node].stress = nodal_conjugate<Layout::rates>(stress, node);
        result.predicted = gradient(nodes, predicted, transverse);
        write_tangent(nodes, predicted, transverse, result.tangent);
        return result;
    }

    /// Writes the nodal strains e_yy, and rates, those of the stress-free state not subtracted.
    void transverse(const Vector<double, dofs>& e,
                    double (&strain)[Layout::shears]) const noexcept {
        Transverse<double> terms;
        transverse_strains(Nodes<double>(e), terms, strain);
        for (int m = 0; m < Layout::shears; ++m) strain[m] += transverse_reference[m];
    }

private:
    template <class S>
    using Transverse = TransverseTerm<NodalScalar<S, Layout::rates>>[2];

    template <bool Second, class S>
    void walk(const Nodes<S>& nodes, PlanarSums<S, Layout>& sums) const noexcept {
        for (const PlanarStation<Layout>& station : stations)
            add_planar_station<Second, Measure>(station, nodes, sums);
        for (const AxialStationData<double, Layout::line>& station : axial)
            add_planar_axial<Second>(station, nodes, sums);
    }

    template <class S>
    void transverse_strains(const Nodes<S>& nodes, Transverse<S>& terms,
                            S (&strain)[Layout::shears]) const noexcept {
        using std::sqrt;
        using C = NodalScalar<S, Layout::rates>;
        for (int node = 0; node < 2; ++node) {
            const C a[2] = {nodes.slope(node, 0), nodes.slope(node, 1)};
            const C square = a[0] * a[0] + a[1] * a[1];
            const bool green = transverse_measure == TransverseStrain::green;
            terms[node].inverse = green ? C(1.0) : nodes.sine[node].inv_a;
            for (int k = 0; k < 2; ++k) terms[node].gradient[k] = terms[node].inverse * a[k];
            const C raw = green ? C(0.5 * (square - 1.0)) : C(sqrt(square) - 1.0);
            if constexpr (Layout::rates) {
                strain[node] = deformation(raw.value, transverse_reference[node]);
                strain[2 + node] = deformation(raw.rate, transverse_reference[2 + node]);
            } else {
                strain[node] = deformation(raw, transverse_reference[node]);
            }
        }
    }

    // The integral of the product of the weights of two nodal strains times the stiffness.
    template <class S>
    [[nodiscard]] S transverse_weight(int m, int other) const noexcept {
        const S W = transverse_stiffness * S(1.0 / 6.0);
        if constexpr (Layout::rates) {
            // of Hermite's cubics over a unit length, in the order of the nodal scalars
            constexpr double products[4][4] = {{78.0, 27.0, 11.0, -6.5},
                                               {27.0, 78.0, 6.5, -11.0},
                                               {11.0, 6.5, 2.0, -1.5},
                                               {-6.5, -11.0, -1.5, 2.0}};
            S weight = W * S(products[m][other] / 35.0);
            for (const int k : {m, other})
                if (k >= 2) weight *= S(transverse_length);
            return weight;
        } else {
            return m == other ? S(2.0 * W) : W;
        }
    }

    template <class S>
    void transverse_stresses(const S (&strain)[Layout::shears],
                             S (&stress)[Layout::shears]) const noexcept {
        if constexpr (Layout::rates) {
            for (int m = 0; m < Layout::shears; ++m) {
                stress[m] = S(0.0);
                for (int k = 0; k < Layout::shears; ++k)
                    stress[m] += transverse_weight<S>(m, k) * strain[k];
            }
        } else {
            const S W = transverse_stiffness * S(1.0 / 6.0);
            stress[0] = W * (2.0 * strain[0] + strain[1]);
            stress[1] = W * (strain[0] + 2.0 * strain[1]);
        }
    }

    template <class S>
    S transverse_terms(const Nodes<S>& nodes, Transverse<S>& terms) const noexcept {
        S strain[Layout::shears], stress[Layout::shears];
        transverse_strains(nodes, terms, strain);
        transverse_stresses(strain, stress);
        for (int node = 0; node < 2; ++node)
            terms[node].stress = nodal_conjugate<Layout::rates>(stress, node);
        S twice = stress[0] * strain[0] + stress[1] * strain[1];
        for (int m = 2; m < Layout::shears; ++m) twice += stress[m] * strain[m];
        return 0.5 * twice;
    }

    template <class S>
    static Vector<S, dofs> gradient(const Nodes<S>& nodes, const PlanarSums<S, Layout>& sums,
                                    const Transverse<S>& transverse) noexcept {
        S by[Layout::size];
        for (int x = 0; x < Layout::vectors; ++x) {
            for (int k = 0; k < 2; ++k) by[2 * x + k] = x < Layout::line ? sums.line[x][k] : S(0.0);
        }
        for (int node = 0; node < 2; ++node) {
            const auto f = nodal_conjugate<Layout::rates>(sums.sine, node);
            for (int k = 0; k < 2; ++k) {
                S* const of_slope = by + 2 * (Layout::a + node) + k;
                add_nodal(f * nodes.sine[node].g[k], by + 2 * (Layout::g + node) + k);
                add_nodal(f * nodes.sine[node].a[k], of_slope);
                add_nodal(transverse[node].stress * transverse[node].gradient[k], of_slope);
            }
        }
        Vector<S, dofs> force;
        for (int k = 0; k < 2; ++k) {
            force[k] = -by[k];
            for (int x = 0; x < Layout::vectors; ++x) force[Layout::start[x] + k] = by[2 * x + k];
        }
        return force;
    }

    // The upper triangle over the components of the nodal vectors, then the rows and columns of
    // r_i.
    template <class S>
    void write_tangent(const Nodes<S>& nodes, const PlanarSums<S, Layout>& sums,
                       const Transverse<S>& transverse, Matrix<S, dofs>& tangent) const noexcept {
        constexpr int size = Layout::size, in_line = 2 * Layout::line, shears = Layout::shears;
        S L[shears][size];
        nodes.gradients(L);
        S Z[shears][size];  // coupling + shear matrix/2 L
        for (int m = 0; m < shears; ++m) {
            for (int k = 0; k < size; ++k) {
                S sum = sums.sine_sine[m][0] * L[0][k];
                for (int n = 1; n < shears; ++n) sum += sums.sine_sine[m][n] * L[n][k];
                Z[m][k] = 0.5 * sum;
                if (k < in_line) Z[m][k] += sums.line_sine[k / 2][k % 2][m];
            }
        }
        S K[size][size];
        for (int j = 0; j < size; ++j) {
            for (int i = 0; i <= j; ++i) {
                S sum = Z[0][i] * L[0][j] + L[0][i] * Z[0][j];
                for (int m = 1; m < shears; ++m) {
                    sum += Z[m][i] * L[m][j];
                    sum += L[m][i] * Z[m][j];
                }
                K[i][j] = sum;
                if (j < in_line) K[i][j] += sums.line_line[i / 2][j / 2][i % 2][j % 2];
            }
        }
        for (int node = 0; node < 2; ++node) {
            add_sine_second(nodes.sine[node], nodal_conjugate<Layout::rates>(sums.sine, node),
                            2 * (Layout::g + node), 2 * (Layout::a + node), K);
        }
        add_transverse_second<S>(transverse, K);
        for (int j = 0; j < size; ++j) {
            const int column = Layout::start[j / 2] + j % 2;
            for (int i = 0; i <= j; ++i) {
                const int row = Layout::start[i / 2] + i % 2;
                tangent(row, column) = tangent(column, row) = K[i][j];
            }
        }
        for (int k = 0; k < 2; ++k) {
            for (int i = 2; i < dofs; ++i)
                tangent(i, k) = tangent(k, i) = -tangent(i, Layout::node + k);
        }
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) tangent(i, k) = tangent(Layout::node + i, Layout::node + k);
        }
    }

    template <class S>
    void add_transverse_second(const Transverse<S>& terms,
                               S (&K)[Layout::size][Layout::size]) const noexcept {
        constexpr int depth = Layout::shears / 2;
        S rows[Layout::shears][2 * depth];  // gradients by the components of a, then of b
        for (int node = 0; node < 2; ++node) {
            for (int k = 0; k < 2; ++k) {
                if constexpr (Layout::rates) {
                    rows[node][k] = rows[2 + node][2 + k] = terms[node].gradient[k].value;
                    rows[node][2 + k] = S(0.0);
                    rows[2 + node][k] = terms[node].gradient[k].rate;
                } else {
                    rows[node][k] = terms[node].gradient[k];
                }
            }
        }
        const auto place = [](int node, int i) {
            return 2 * (Layout::a + node) + i % 2 + i / 2 * planar_rate;
        };
        for (int m = 0; m < Layout::shears; ++m) {
            for (int other = depth == 1 ? m : 0; other < Layout::shears; ++other) {
                const S weight = transverse_weight<S>(m, other);
                for (int i = 0; i < 2 * depth; ++i) {
                    for (int j = 0; j < 2 * depth; ++j) {
                        const int row = place(m % 2, i), column = place(other % 2, j);
                        if (row <= column) K[row][column] += weight * rows[m][i] * rows[other][j];
                    }
                }
            }
        }
        for (int node = 0; node < 2; ++node) {
            const TransverseTerm<NodalScalar<S, Layout::rates>>& term = terms[node];
            const auto share = term.stress * term.inverse;
            const bool green = transverse_measure == TransverseStrain::green;
            for (int j = 0; j < 2; ++j) {
                add_nodal(share, place(node, j), place(node, j), true, K);
                for (int i = 0; i <= j && !green; ++i)
                    add_nodal(decltype(share)(-(share * term.gradient[i] * term.gradient[j])),
                              place(node, i), place(node, j), true, K);
            }
        }
    }
};

}  // namespace ancf::detail
