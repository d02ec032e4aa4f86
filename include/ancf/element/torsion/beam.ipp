// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/element/mass.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/error.hpp>

#include <algorithm>
#include <cmath>

namespace ancf {

ANCF_LAZY TorsionBeam::TorsionBeam(const Material& material, const Section& section, double length,
                                   const Options& options)
    : LineElement(length, options) {
    set_up(material, section);
}

ANCF_LAZY TorsionBeam::TorsionBeam(const Material& material, const Section& section,
                                   const Coordinates& reference, double length,
                                   const Options& options)
    : LineElement(reference, length, options) {
    set_up(material, section);
    require_admissible("slopes of some length, r_y not along the tangent");
    kernel_.set_reference(reference);
}

ANCF_LAZY void TorsionBeam::set_up(const Material& material, const Section& section) {
    material.validate();
    detail::require_points(options_.rule, StrainGroup::axial, "axial", 3);
    detail::require_points(options_.rule, StrainGroup::bending, "bending", 2);
    detail::require_points(options_.rule, StrainGroup::torsion, "torsion", 1);
    detail::require(!section.has_shear_centre(),
                    "a torsion beam's shear centre is its axis: leave out with_shear_centre");
    const Moments& m = section.moments();
    const double size = std::sqrt(std::max(m.yy, m.zz) * m.area);
    detail::require(std::abs(m.y) <= 1e-9 * size && std::abs(m.z) <= 1e-9 * size,
                    "a torsion beam's section must be centred on the axis, got first moments ", m.y,
                    " and ", m.z);
    young_ = material.young;
    axial_ = material.young * m.area;
    bending_ << m.yy, m.yz, m.yz, m.zz;
    bending_ *= material.young;
    torsion_ = material.shear * section.torsion_constant();
    for (const RuleStation& station : options_.rule.stations()) {
        const StationShape<double> shape = line_.shape(station.xi);
        const double length = line_.parameter_length() * line_.metric(station.xi);
        const double axial = station.weight(StrainGroup::axial);
        const double bending = station.weight(StrainGroup::bending) * length;
        const double torsion = station.weight(StrainGroup::torsion) * length;
        if (axial != 0.0)
            kernel_.axial.push_back(
                {{shape.p[0], shape.p[1], shape.p[2]}, 0.0, axial_ * axial * length});
        if (bending == 0.0 && torsion == 0.0) continue;
        kernel_.stations.push_back({shape,
                                    {},
                                    {{bending * bending_(0, 0), bending * bending_(0, 1), 0.0},
                                     {bending * bending_(1, 0), bending * bending_(1, 1), 0.0},
                                     {0.0, 0.0, torsion * torsion_}}});
    }
    for (detail::TorsionHold& hold : kernel_.holds) {
        hold.stretching = 0.5 * axial_ * line_.length();
        hold.shear = 0.5 * material.shear * m.area * line_.length();
    }
    Moments polar;
    const Moments& mass = detail::mass_on_line<3>(section);
    polar.area = mass.area;
    polar.yy = mass.polar();
    mass_weights_ = line_.mass<3>(material.density, polar);
}

ANCF_LAZY bool TorsionBeam::admissible(const Coordinates& e) const noexcept {
    if (!detail::all_finite(e)) return false;
    constexpr double smallest = 1e-6, least = 0.5 * smallest * smallest;
    for (int node = 0; node < 2; ++node) {
        const Vector<double, 3> g = e.segment<3>(9 * node + 3), a = e.segment<3>(9 * node + 6);
        if (!(g.norm() > smallest && a.norm() > smallest)) return false;
        if (!(cross(g, a).norm() > smallest * g.norm() * a.norm())) return false;
    }
    const detail::TorsionNodes<double> nodes(e);
    for (const detail::TorsionStation& station : kernel_.stations) {
        const detail::Vec3<double> p = detail::line_sum(station.shape.p, nodes.vector);
        const double square = detail::dot(p, p);
        if (!(square > smallest * smallest)) return false;
        const detail::Vec3<double> t = (1.0 / std::sqrt(square)) * p;
        for (const detail::NodalDirector<double>& y : nodes.y)
            if (!(1.0 + detail::dot(y.t, t) > least)) return false;
        const double turn =
            detail::dot(detail::carried(nodes.y[0], t), detail::carried(nodes.y[1], t));
        if (!(turn > -0.8660254)) return false;  // 150 degrees
    }
    return true;
}

ANCF_LAZY Vector<double, 4> TorsionBeam::strains(const Coordinates& e, double xi) const noexcept {
    return beyond_reference(e, [&](const Coordinates& state) {
        detail::Invariants<double> w;
        (void)frame(state, xi, w);
        return Vector<double, 4>(0.5 * (w.lam * w.lam - 1.0), -w.kap, -w.chi, w.om);
    });
}

ANCF_LAZY SectionForces TorsionBeam::section_forces(const Coordinates& e,
                                                    double xi) const noexcept {
    const Vector<double, 4> s = strains(e, xi);
    detail::Invariants<double> w;
    (void)frame(e, xi, w);
    const Vector<double, 2> moment = bending_ * s.segment<2>(1);
    return {axial_ * s[0] * w.lam, 0.0, 0.0, torsion_ * s[3], moment[1], -moment[0]};
}

ANCF_LAZY Matrix<double, 3, TorsionBeam::dofs> TorsionBeam::position_jacobian(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    using namespace detail;
    const TorsionNodes<double> nodes(e);
    const StationShape<double> shape = line_.shape(xi);
    TorsionState<double> at;
    torsion_state(shape, nodes, at);
    const CarriedFrame<double>& f = at.frame;
    // d n = th c - (n.dt) t and d c = -th n - (c.dt) t, with dt = (I - t t^T) dp/lam
    const Vector<double, 3> t = to_vector(f.t), n = to_vector(f.n), c = to_vector(f.c);
    Matrix<double, 3, torsion_local> local = Matrix<double, 3, torsion_local>::Zero();
    const Vector<double, 3> turned = y * c - z * n;
    const Matrix<double, 3> tilt = -f.inv_lam * t * (y * n + z * c).transpose();
    for (int a = 0; a < 3; ++a) local.middleCols<3>(3 * a) = shape.p[a] * tilt;
    local.leftCols<torsion_line>() += turned * at.spin.head<torsion_line>().transpose();
    for (int node = 0; node < 2; ++node) {
        const NodalDirector<double>& d = nodes.y[node];
        const double weight = at.spin[torsion_line + node];
        for (int k = 0; k < 3; ++k) {
            local.col(3 * (tv_a1 + node) + k) += weight * d.inv_nu * d.c[k] * turned;
            local.col(3 * (tv_g1 + node) + k) -= weight * d.al * d.inv_g * d.c[k] * turned;
        }
    }
    Matrix<double, 3, dofs> result = Matrix<double, 3, dofs>::Zero();
    for (int i = 0; i < torsion_local; ++i) result.col(torsion_place[i]) = local.col(i);
    result.leftCols<3>() = -local.leftCols<3>();
    line_.add_point_jacobian(xi, result);
    return result;
}

ANCF_LAZY Vector<double, 1> TorsionBeam::stress(const Coordinates& e, double xi, double y,
                                                double z) const noexcept {
    const Vector<double, 4> s = strains(e, xi);
    return Vector<double, 1>(young_ * (s[0] + y * s[1] + z * s[2]));
}

}  // namespace ancf
