// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Constant data of the stations of an element: shape weights, reference strains, section matrix.
///
/// Lengths along the element are those of its stress-free state; derivatives are with respect to
/// that arc length. The quadrature weight and the length are folded into the stiffness. T is
/// double, or a pack of doubles that holds several stations or several elements side by side.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/list.hpp>
#include <ancf/section/stiffness.hpp>

#include <cstddef>

namespace ancf {

/// The blocks of the section matrix of the twelve generalised strains.
template <class T>
struct SectionMatrix {
    T axial[6][6];    ///< of (eps, b_y, b_z, a_yy/2, a_yz, a_zz/2)
    T shear_y[3][3];  ///< of (g_y, h_yy, h_zy)
    T shear_z[3][3];  ///< of (g_z, h_yz, h_zz)
};

/// Weights of the nodal vectors and four nodal shears in the local vectors of a station.
/// @tparam Line  number of nodal vectors in the centre line: 3, or 5 of a quintic
template <class T, int Line = 3>
struct StationShape {
    T p[Line];   ///< of (D, g1, g2, k1, k2) in p = r0', D = r_j - r_i; 1/m, 1, 1, m, m
    T p1[Line];  ///< of the same in p1 = r0''; 1/m^2, 1/m, 1/m, 1, 1
    T n2;        ///< of a2 in a = r_y; a1 has 1 - n2. Also of b2
    T n2_x;      ///< of a2 in a1 = r_y'; a1 has -n2_x, 1/m. Also of the second node's shears
    T n2_s;      ///< of the second node's shears: n2, or nearer to 1/2 (shear_weight)
};

/// A station that integrates any terms of the energy.
template <class T, int Line = 3>
struct StationData {
    StationShape<T, Line> shape;        ///< weights of the nodal vectors
    T reference[detail::strain_count];  ///< strains of the stress-free state, subtracted
    SectionMatrix<T> stiffness;         ///< times weight and length
};

/// A station that integrates only EA eps^2/2.
template <class T, int Line = 3>
struct AxialStationData {
    T p[Line];    ///< of (D, g1, g2, k1, k2) in p = r0'
    T reference;  ///< axial strain of the stress-free state, subtracted
    T stiffness;  ///< EA times weight and length
};

/// The stations of a rule.
template <class T, int Line = 3>
struct StationTable {
    List<StationData<T, Line>> full;        ///< stations of all strains
    List<AxialStationData<T, Line>> axial;  ///< stations of the axial strain alone
};

/// Returns the shape weights at xi of a straight element of the given length.
template <class Line = CubicLine>
[[nodiscard]] StationShape<double, Line::vectors> straight_shape(double xi,
                                                                 double length) noexcept {
    const auto first = Line::first(xi, length);
    const auto second = Line::second(xi, length);
    StationShape<double, Line::vectors> shape;
    for (std::size_t k = 0; k < first.size(); ++k) {
        shape.p[k] = first[k];
        shape.p1[k] = second[k];
    }
    shape.n2 = xi;
    shape.n2_x = 1.0 / length;
    shape.n2_s = xi;
    return shape;
}

/// Returns the section matrix times the station's weight of each term's group and a length.
[[nodiscard]] inline SectionMatrix<double> station_stiffness(const SectionStiffness& section,
                                                             const RuleStation& station,
                                                             double length) noexcept {
    SectionMatrix<double> result;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const StrainGroup group = i + j == 0 ? StrainGroup::axial : StrainGroup::bending;
            result.axial[i][j] = section.axial(i, j) * length * station.weight(group);
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const StrainGroup group = i + j == 0 ? StrainGroup::shear : StrainGroup::torsion;
            const double weight = length * station.weight(group);
            result.shear_y[i][j] = section.shear_y(i, j) * weight;
            result.shear_z[i][j] = section.shear_z(i, j) * weight;
        }
    }
    return result;
}

namespace detail {

/// Sets one lane of every entry of packed data.
template <int Lanes>
inline void put_lane(Pack<Lanes>& to, int lane, double from) noexcept {
    to.set(lane, from);
}
template <class Packed, class Plain, std::size_t Count>
inline void put_lane(Packed (&to)[Count], int lane, const Plain (&from)[Count]) noexcept {
    for (std::size_t k = 0; k < Count; ++k) put_lane(to[k], lane, from[k]);
}
template <int Lanes, int Line>
inline void put_lane(StationData<Pack<Lanes>, Line>& to, int lane,
                     const StationData<double, Line>& from) noexcept {
    put_lane(to.shape.p, lane, from.shape.p);
    put_lane(to.shape.p1, lane, from.shape.p1);
    put_lane(to.shape.n2, lane, from.shape.n2);
    put_lane(to.shape.n2_x, lane, from.shape.n2_x);
    put_lane(to.shape.n2_s, lane, from.shape.n2_s);
    put_lane(to.reference, lane, from.reference);
    put_lane(to.stiffness.axial, lane, from.stiffness.axial);
    put_lane(to.stiffness.shear_y, lane, from.stiffness.shear_y);
    put_lane(to.stiffness.shear_z, lane, from.stiffness.shear_z);
}

template <int Lanes, int Line>
inline void put_lane(AxialStationData<Pack<Lanes>, Line>& to, int lane,
                     const AxialStationData<double, Line>& from) noexcept {
    put_lane(to.p, lane, from.p);
    put_lane(to.reference, lane, from.reference);
    put_lane(to.stiffness, lane, from.stiffness);
}

/// A station like the given one that adds nothing: fills lanes left over.
template <int Line>
StationData<double, Line> without_stiffness(StationData<double, Line> station) noexcept {
    station.stiffness = {};
    return station;
}
template <int Line>
AxialStationData<double, Line> without_stiffness(AxialStationData<double, Line> station) noexcept {
    station.stiffness = 0.0;
    return station;
}

/// Sets one lane of a table that may have more stations than the lane has.
template <int Lanes, int Line>
inline void put_lane(StationTable<Pack<Lanes>, Line>& to, int lane,
                     const StationTable<double, Line>& from) noexcept {
    for (std::size_t k = 0; k < to.full.size(); ++k)
        put_lane(to.full[k], lane,
                 k < from.full.size() ? from.full[k] : without_stiffness(from.full.back()));
    for (std::size_t k = 0; k < to.axial.size(); ++k)
        put_lane(to.axial[k], lane,
                 k < from.axial.size() ? from.axial[k] : AxialStationData<double, Line>{});
}

template <int Lanes, int Line, template <class, int> class Data>
[[nodiscard]] List<Data<Pack<Lanes>, Line>> packed(const List<Data<double, Line>>& stations) {
    List<Data<Pack<Lanes>, Line>> packs((stations.size() + Lanes - 1) / Lanes);
    for (std::size_t k = 0; k < packs.size() * Lanes; ++k) {
        put_lane(packs[k / Lanes], static_cast<int>(k % Lanes),
                 k < stations.size() ? stations[k] : without_stiffness(stations.back()));
    }
    return packs;
}

}  // namespace detail

/// Returns the stations side by side, Lanes to a pack.
template <int Lanes, int Line>
[[nodiscard]] StationTable<Pack<Lanes>, Line> packed(const StationTable<double, Line>& table) {
    return {detail::packed<Lanes>(table.full), detail::packed<Lanes>(table.axial)};
}

}  // namespace ancf
