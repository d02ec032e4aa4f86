// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard cases of the cable, which has neither shear nor torsion: bending, against the elastica.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <hard_cases/cases.hpp>

#include <cmath>
#include <string>

namespace hard_cases {

namespace {

using Element = ancf::Cable<3, ancf::EngineeringAxial>;
using Scene = ancf::Model;
using Point = ancf::Vector<double, 3>;

Row make(std::string name, int elements, double limit) {
    return make_row("cable", ancf::cable_rule().name(), std::move(name), elements, limit);
}

/// A beam of length 1 m and E I = 1 N m^2, clamped at one end.
class Cantilever {
public:
    Cantilever(double height, int elements) {
        const double young = 12.0 / std::pow(height, 4);
        beam_ = ancf::straight_beam<Element>(
            scene_, ancf::Material::from_moduli(young, 0.4 * young, 1.0),
            ancf::rectangle(height, height), {0, 0, 0}, {1, 0, 0}, elements);
        scene_.clamp(beam_.first(), ancf::Clamp::full);
    }

    template <class Load>
    void add(const Load& load) {
        scene_.add(load);
    }
    [[nodiscard]] ancf::NodeId end() const { return beam_.last(); }

    /// Loads it and fills in how far the tip ends from `theory`.
    void solve(Row& row, const Point& theory) {
        const double start = now();
        ancf::StaticsOptions how;
        how.adaptive = true;
        ancf::EigenLu solver;
        set(row, ancf::solve_statics(scene_, solver, how));
        row.error = (scene_.position(end()) - theory).norm();
        row.seconds = now() - start;
    }

private:
    Scene scene_;
    ancf::Beam<Element> beam_;
};

/// The load of the paper's slender cantilever.
void slender(Rows& rows, bool quick) {
    for (const int elements : {1, 2, 4, 8, 16}) {
        if (quick && elements > 4) break;
        Row row = make("slender_cantilever", elements, 0.06 / std::pow(elements, 3));
        Cantilever cantilever(1e-4, elements);
        cantilever.add(ancf::Force<3>(cantilever.end(), {0, 1.5, 0}));
        cantilever.solve(row, {0.5 * 1.784116998633, 0.5 * 0.821956422496, 0});
        rows.push_back(row);
    }
}

/// The elastica of P L^2/E I = 10.
void slenderness(Rows& rows, bool quick) {
    for (const double height : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        if (quick && height < 1e-3) break;
        Row row = make("slenderness_" + std::to_string(std::lround(1.0 / height)), quick ? 8 : 64,
                       2.0 * height * height + (quick ? 2e-2 : 1e-4));
        Cantilever cantilever(height, row.elements);
        cantilever.add(ancf::Force<3>(cantilever.end(), {0, 10, 0}));
        cantilever.solve(row, {0.445004402246, 0.810609024880, 0});
        rows.push_back(row);
    }
}

/// An end moment that rolls it up.
void rolled(Rows& rows, const std::string& name, int elements, double circles) {
    Row row = make(name, elements, 0.01);
    Cantilever cantilever(5e-3, elements);
    cantilever.add(ancf::TangentMoment(cantilever.end(), {0, 0, 2.0 * pi * circles}));
    cantilever.solve(row, {0, circles == 0.5 ? 2.0 / pi : 0.0, 0});
    rows.push_back(row);
}

}  // namespace

std::vector<Case> cable_cases() {
    const std::vector<Case> all = {
        {"slender_cantilever", slender},
        {"slenderness", slenderness},
        {"semicircle", [](Rows& rows, bool) { rolled(rows, "semicircle", 8, 0.5); }},
        {"two_circles", [](Rows& rows, bool) { rolled(rows, "two_circles", 20, 2.0); }},
        {"four_circles",
         [](Rows& rows, bool quick) {
             if (!quick) rolled(rows, "four_circles", 40, 4.0);
         }},
    };
    return of_element("cable", all);
}

}  // namespace hard_cases
