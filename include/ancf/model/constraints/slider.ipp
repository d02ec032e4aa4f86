// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraints/slider.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

namespace ancf {

namespace detail {

/// Returns a polynomial, or a derivative of it.
template <int Derivative = 0, class Scalar>
[[nodiscard]] Scalar of_powers(const GuidePiece::Powers& powers, const Scalar& xi) {
    Scalar out(0.0);
    for (int k = 5; k >= Derivative; --k) {
        const int factor = Derivative == 0 ? 1 : Derivative == 1 ? k : k * (k - 1);
        out = xi * out + factor * powers[k];
    }
    return out;
}

/// Returns the sum of the vectors of a piece so weighted.
/// @param q  coordinates of which those of the guide begin at `first`.
template <int Dimension, int Derivative = 0, class Scalar>
[[nodiscard]] Vector<Scalar, Dimension> weighted(const GuidePiece& piece,
                                                 const List<GuidePiece::Powers>& weights,
                                                 const Scalar& xi, const DynamicVector<Scalar>& q,
                                                 int first) {
    Vector<Scalar, Dimension> out = Vector<Scalar, Dimension>::Zero();
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const Scalar weight = of_powers<Derivative>(weights[k], xi);
        for (int i = 0; i < Dimension; ++i)
            out[i] += weight * q[first + Dimension * piece.vectors[k] + i];
    }
    return out;
}

/// The difference d from a guide's place to a point p, and the guide's derivatives by xi there.
template <class Scalar, int Dimension>
struct GuideGap {
    Vector<Scalar, Dimension> d, first, second;
    Scalar full;  ///< -d(d.first)/dxi

    GuideGap(const GuidePiece& piece, const Scalar& xi, const DynamicVector<Scalar>& q, int start,
             const Vector<Scalar, Dimension>& p)
        : d(p - weighted<Dimension>(piece, piece.line, xi, q, start)),
          first(weighted<Dimension, 1>(piece, piece.line, xi, q, start)),
          second(weighted<Dimension, 2>(piece, piece.line, xi, q, start)),
          full(product(first, first) - product(second, d)) {}
};

/// Returns the parameter of the place of a piece next to p.
template <int Dimension>
[[nodiscard]] double next_to(const Vector<double, Dimension>& p, const GuidePiece& piece,
                             const VectorX& q, int start) {
    const auto within = [&](double xi) { return std::clamp(xi, piece.first, piece.last); };
    double nearest = within(0.0), least = std::numeric_limits<double>::infinity();
    for (const double sample : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double xi = within(sample);
        const Vector<double, Dimension> d =
            p - weighted<Dimension>(piece, piece.line, xi, q, start);
        if (product(d, d) < least) least = product(d, d), nearest = xi;
    }
    for (int iteration = 0; iteration < 30; ++iteration) {
        const GuideGap<double, Dimension> gap(piece, nearest, q, start, p);
        const double slope = std::max(gap.full, 0.5 * product(gap.first, gap.first));
        const double xi = within(nearest + product(gap.first, gap.d) / slope);
        if (xi == nearest || !std::isfinite(xi)) return xi;
        nearest = xi;
    }
    return nearest;
}

/// Returns the place of a vector, which it appends where it is not there.
[[nodiscard]] ANCF_INLINE int place_in(Coupling& vectors, NodeId node, Field field) {
    for (std::size_t k = 0; k < vectors.size(); ++k)
        if (vectors[k].node == node && vectors[k].field == field) return static_cast<int>(k);
    vectors.push_back({node, field});
    return static_cast<int>(vectors.size()) - 1;
}

/// Returns the straight line that goes on at an end of a piece.
[[nodiscard]] ANCF_INLINE GuidePiece straight_on(const GuidePiece& piece, double end) {
    GuidePiece out = piece;
    for (auto* weights : {&out.line, &out.across})
        for (GuidePiece::Powers& powers : *weights) {
            const double slope = weights == &out.line ? of_powers<1>(powers, end) : 0.0;
            powers = {of_powers(powers, end) - end * slope, slope};
        }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    out.first = end == 0.0 ? -infinity : 1.0;
    out.last = end == 0.0 ? 0.0 : infinity;
    return out;
}

/// Returns the weights by powers of the centre line of an element: of r, r_x and, where it is
/// quintic, r_xx of its first node, then of its second one; element/hermite.hpp.
[[nodiscard]] ANCF_INLINE List<GuidePiece::Powers> line_powers(bool quintic, double l) {
    if (!quintic) return {{1, 0, -3, 2}, {0, l, -2 * l, l}, {0, 0, 3, -2}, {0, 0, -l, l}};
    const double h = 0.5 * l * l;
    return {{1, 0, 0, -10, 15, -6}, {0, l, 0, -6 * l, 8 * l, -3 * l}, {0, 0, h, -3 * h, 3 * h, -h},
            {0, 0, 0, 10, -15, 6},  {0, 0, 0, -4 * l, 7 * l, -3 * l}, {0, 0, 0, h, -2 * h, h}};
}

template <int Dimension>
Guide<Dimension> guide_of_lines(const List<Connection>& elements, const List<double>& lengths,
                                Fields fields, const Vector<double, Dimension>& across) {
    require(!elements.empty(), "guide_along: a guide needs an element");
    const bool quintic = fields.contains(Field::r_xx), section = fields.contains(Field::r_y);
    require(Dimension == 2 || section || (all_finite(across) && across.norm() > 0.0),
            "guide_along: elements without r_y need a direction `across` that the line never "
            "takes, got ",
            components(across));
    Guide<Dimension> out = {{},
                            {},
                            across,
                            joined({"the line from node ", elements.front().first.index,
                                    " to node ", elements.back().second.index})};
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const Connection& at = elements[e];
        require(e == 0 || at.first == elements[e - 1].second, "guide_along: element ", e,
                " of the guide begins at node ", at.first.index, ", the one before ends at node ",
                elements[e - 1].second.index);
        GuidePiece piece;
        piece.start = static_cast<double>(e);
        piece.line = line_powers(quintic, lengths[e]);
        for (const NodeId node : {at.first, at.second})
            for (const Field field : {Field::r, Field::r_x, Field::r_xx})
                if (fields.contains(field))
                    piece.vectors.push_back(place_in(out.vectors, node, field));
        if (Dimension == 3 && section) {
            piece.across.resize(piece.vectors.size());
            piece.across.push_back({1, -1});
            piece.across.push_back({0, 1});
            piece.line.resize(piece.across.size());
            for (const NodeId node : {at.first, at.second})
                piece.vectors.push_back(place_in(out.vectors, node, Field::r_y));
        }
        out.pieces.push_back(std::move(piece));
    }
    if (elements.back().second == elements.front().first) return out;
    out.pieces.push_back(straight_on(out.pieces.back(), 1.0));
    out.pieces.push_back(straight_on(out.pieces.front(), 0.0));
    return out;
}

}  // namespace detail

template <int Dimension>
Guide<Dimension> straight_guide(const BasicModel<Dimension>& model, NodeId node,
                                const Vector<double, Dimension>& direction) {
    using Point = Vector<double, Dimension>;
    const double size = detail::span(direction);
    detail::require(std::isfinite(size) && size > 0.0,
                    "straight_guide: the direction must have a length, got ",
                    detail::components(direction));
    const Point unit = direction / size, x = model.value(node, Field::r_x),
                y = model.value(node, Field::r_y);
    Guide<Dimension> out = {{}, {}, Vector<double, Dimension>::Zero(), {}};
    out.name = detail::joined({"a line through node ", node.index});
    out.vectors = {{node, Field::r}, {node, Field::r_x}, {node, Field::r_y}};
    detail::GuidePiece piece;
    piece.vectors = {0, 1, 2};
    piece.line = {{1}};
    double volume = x[0] * y[1] - x[1] * y[0];
    if constexpr (Dimension == 2) {
        piece.line.push_back({0, (unit[0] * y[1] - unit[1] * y[0]) / volume});
        piece.line.push_back({0, (x[0] * unit[1] - x[1] * unit[0]) / volume});
    } else {
        const Point z = model.value(node, Field::r_z);
        const Point faces[3] = {cross(y, z), cross(z, x), cross(x, y)};
        volume = detail::product(faces[0], x);
        const Point normal =
            detail::to_vector(detail::normals_of(detail::vec3<double>(unit)).front());
        piece.across = {{}};
        for (const Point& face : faces) {
            piece.line.push_back({0, detail::product(face, unit) / volume});
            piece.across.push_back({detail::product(face, normal) / volume});
        }
        piece.vectors.push_back(3);
        out.vectors.push_back({node, Field::r_z});
    }
    detail::require(std::abs(volume) > 0.0, "straight_guide: the slopes of node ", node.index,
                    " have no volume");
    piece.last = std::numeric_limits<double>::infinity();
    piece.first = -piece.last;
    out.pieces.push_back(std::move(piece));
    return out;
}

template <int Dimension>
Slider<Dimension>::Slider(MaterialPoint point, Guide<Dimension> guide)
    : point_(std::move(point)), guide_(std::move(guide)) {
    detail::require(!guide_.pieces.empty(),
                    "Slider: the guide is empty; guide_along() and "
                    "straight_guide() make one");
    for (const NodeField& of_point : point_.vectors)
        for (const NodeField& of_guide : guide_.vectors)
            detail::require(of_point.node != of_guide.node, "Slider: node ", of_guide.node.index,
                            ", of ", point_.name, ", is a node of the guide");
}

template <int Dimension>
Coupling Slider<Dimension>::coupling() const {
    Coupling all = point_.vectors;
    all.insert(all.end(), guide_.vectors.begin(), guide_.vectors.end());
    return all;
}

template <int Dimension>
List<Coupling> Slider<Dimension>::stiffness_parts() const {
    List<Coupling> parts;
    for (const detail::GuidePiece& piece : guide_.pieces) {
        parts.push_back(point_.vectors);
        for (const int vector : piece.vectors) parts.back().push_back(guide_.vectors[vector]);
    }
    return parts;
}

template <int Dimension>
double Slider<Dimension>::station(const BasicModel<Dimension>& model, const VectorX& q) const {
    VectorX local(Dimension * static_cast<Eigen::Index>(coupling().size()));
    Eigen::Index at = 0;
    for (const NodeField& vector : coupling()) {
        const Vector<double, Dimension> value = model.value(vector.node, vector.field, q);
        for (int i = 0; i < Dimension; ++i) local[at++] = value[i];
    }
    const Place now = place(local);
    return now.piece->start + now.xi;
}

template <int Dimension>
template <class Scalar>
Vector<Scalar, Dimension> Slider<Dimension>::position(const DynamicVector<Scalar>& q) const {
    Vector<Scalar, Dimension> p = Vector<Scalar, Dimension>::Zero();
    for (int i = 0; i < guide_start(); ++i)
        p[i % Dimension] += point_.weights[i / Dimension] * q[i];
    return p;
}

template <int Dimension>
typename Slider<Dimension>::Place Slider<Dimension>::place(const VectorX& q) const {
    const Vector<double, Dimension> p = position(q);
    Place best{&guide_.pieces.front(), 0.0};
    double least = std::numeric_limits<double>::infinity();
    for (const detail::GuidePiece& piece : guide_.pieces) {
        const double xi = detail::next_to(p, piece, q, guide_start());
        const Vector<double, Dimension> d =
            p - detail::weighted<Dimension>(piece, piece.line, xi, q, guide_start());
        if (detail::product(d, d) >= least) continue;
        least = detail::product(d, d);
        best = {&piece, xi};
    }
    return best;
}

template <int Dimension>
List<int> Slider<Dimension>::coordinates(const Place& at) const {
    List<int> out;
    for (int i = 0; i < guide_start(); ++i) out.push_back(i);
    for (const int vector : at.piece->vectors)
        for (int i = 0; i < Dimension; ++i) out.push_back(guide_start() + Dimension * vector + i);
    return out;
}

template <int Dimension>
template <class Scalar>
ConstraintTerms<Scalar> Slider<Dimension>::terms_at(const Place& at,
                                                    const DynamicVector<Scalar>& q) const {
    using Point = Vector<Scalar, Dimension>;
    using detail::of_powers;
    using detail::product;
    using std::sqrt;
    const detail::GuidePiece& piece = *at.piece;
    const int start = guide_start(), of_point = start / Dimension;
    const int vectors = of_point + static_cast<int>(piece.vectors.size());
    ConstraintTerms<Scalar> out;
    out.reset(Dimension - 1, Dimension * vectors);
    // A step of Newton's method continues xi into the complex plane.
    const Point p = position(q);
    const detail::GuideGap<Scalar, Dimension> near(piece, Scalar(at.xi), q, start, p);
    const Scalar xi = at.xi + product(near.first, near.d) / near.full;
    const detail::GuideGap<Scalar, Dimension> gap(piece, xi, q, start, p);
    const Scalar size = sqrt(product(gap.first, gap.first));
    const Point t = gap.first / size;
    std::array<Point, Dimension - 1> n;
    Point a = Point::Zero(), bend = Point::Zero();
    Scalar along(0.0), height(1.0);
    if constexpr (Dimension == 2) {
        n[0] = {-t[1], t[0]};
    } else {
        a = guide_.across.template cast<Scalar>();
        if (!piece.across.empty()) {
            a = detail::weighted<3>(piece, piece.across, xi, q, start);
            bend = detail::weighted<3, 1>(piece, piece.across, xi, q, start);
        }
        along = product(a, t);
        const Point y = a - along * t;
        height = sqrt(product(y, y));
        n = {y / height, cross(t, Point(y / height))};
    }
    for (int k = 0; k < Dimension - 1; ++k) out.violation[k] = product(n[k], gap.d);
    for (int vector = 0; vector < vectors; ++vector) {
        const int k = vector - of_point;
        const Scalar w = k < 0 ? Scalar(point_.weights[vector]) : -of_powers(piece.line[k], xi);
        for (int i = 0; i < Dimension; ++i)
            for (int row = 0; row < Dimension - 1; ++row)
                out.jacobian(row, Dimension * vector + i) = w * n[row][i];
        if constexpr (Dimension == 3) {
            // n_1 and n_2 spin about t
            const Scalar slope = k < 0 ? Scalar(0.0) : of_powers<1>(piece.line[k], xi);
            const Scalar turn =
                k < 0 || piece.across.empty() ? Scalar(0.0) : of_powers(piece.across[k], xi);
            const Scalar by_xi = product(n[1], bend) - along / size * product(n[1], gap.second);
            for (int i = 0; i < 3; ++i) {
                const Scalar shift = (w * gap.first[i] + slope * gap.d[i]) / gap.full;
                const Scalar spin =
                    ((turn - along / size * slope) * n[1][i] + by_xi * shift) / height;
                out.jacobian(0, 3 * vector + i) += out.violation[1] * spin;
                out.jacobian(1, 3 * vector + i) -= out.violation[0] * spin;
            }
        }
    }
    return out;
}

template <int Dimension>
template <class Scalar>
void Slider<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& /*time*/,
                              ConstraintTerms<Scalar>& out) const {
    write(place(q.real()), q, out);
}

template <int Dimension>
template <class Scalar>
void Slider<Dimension>::write(const Place& at, const DynamicVector<Scalar>& q,
                              ConstraintTerms<Scalar>& out) const {
    const ConstraintTerms<Scalar> found = terms_at(at, q);
    out.violation = found.violation;
    Eigen::Index j = 0;
    for (const int coordinate : coordinates(at))
        out.jacobian.col(coordinate) = found.jacobian.col(j++);
}

template <int Dimension>
void Slider<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    const Place here = place(at.q);
    write(here, at.q, out);
    // Second derivatives by complex steps, exact to round-off.
    out.active = coordinates(here);
    const List<int>& local = out.active;
    out.stiffness.setZero(static_cast<Eigen::Index>(local.size()),
                          static_cast<Eigen::Index>(local.size()));
    DynamicVector<std::complex<double>> q = at.q.template cast<std::complex<double>>();
    constexpr double step = 1e-40;
    for (Eigen::Index j = 0; j < out.stiffness.cols(); ++j) {
        q[local[j]].imag(step);
        const auto moved = terms_at(here, q);
        q[local[j]].imag(0.0);
        for (Eigen::Index i = 0; i < out.stiffness.rows(); ++i)
            for (int k = 0; k < Dimension - 1; ++k) {
                const double slope = moved.jacobian(k, i).imag() / step;
                out.stiffness(i, j) += at.multipliers[k] * slope;
                out.convection[k] += at.v[local[i]] * slope * at.v[local[j]];
            }
    }
}

#if defined(ANCF_SOURCE)
template Guide<2> straight_guide(const BasicModel<2>&, NodeId, const Vector<double, 2>&);
template Guide<3> straight_guide(const BasicModel<3>&, NodeId, const Vector<double, 3>&);
template Guide<2> detail::guide_of_lines(const List<Connection>&, const List<double>&, Fields,
                                         const Vector<double, 2>&);
template Guide<3> detail::guide_of_lines(const List<Connection>&, const List<double>&, Fields,
                                         const Vector<double, 3>&);
template class Slider<2>;
template class Slider<3>;
ANCF_CONSTRAINT_INSTANCES(Slider<2>)
ANCF_CONSTRAINT_INSTANCES(Slider<3>)
#endif

}  // namespace ancf
