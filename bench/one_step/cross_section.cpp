// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>

#include <one_step/rows.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace ancf::bench::one_step {

namespace {

/// The bend of the paper's element, by its own section and rule.
void add_paper_bends(std::vector<Row>& rows) {
    using Projecting = CrossSectionBeam<3>;
    add_bends<Projecting>(rows, "projected, paper", Projecting::Options(),
                          Point(47.150438573629, 15.684800534039, 53.474858791825));
}

/// Ibrahimbegovic's helix of ten turns by the options best() alone.
template <class Element>
void add_helix(std::vector<Row>& rows, int elements) {
    rows.push_back(
        {"helix, " + std::to_string(elements) + " elements, " + measure<Element>(), 100,
         [elements] {
             Problem p;
             Moments moments;
             moments.area = 1.0;
             moments.yy = moments.zz = 0.01;
             const auto section = Section::from_moments(moments)
                                      .with_shear_correction(1.0, 1.0)
                                      .with_torsion_constant(0.01);
             const auto beam =
                 straight_beam<Element>(p.scene, Material::from_moduli(1e4, 1e4, 1.0), section,
                                        {0, 0, 0}, {10, 0, 0}, elements, Element::Options::best());
             p.scene.clamp(beam.first(), clamp_of<Element>);
             p.scene.add(Moment(beam.last(), {0, 0, 200.0 * pi}));
             p.scene.add(Force<3>(beam.last(), {0, 0, 50.0}));
             p.end = beam.last();
             return p;
         },
         std::is_same_v<Element, Engineering> || std::is_same_v<Element, QuinticEngineering>,
         Point(0.004803250, 0.000072497, -0.076441742), 10.0});
}

}  // namespace

std::vector<Row> cross_section_rows() {
    std::vector<Row> rows;
    add_elastica<Green>(rows);
    add_elastica<Engineering>(rows);
    add_bends<Green>(rows);
    add_bends<Engineering>(rows);
    add_bends<Quintic>(rows);
    add_paper_bends(rows);
    add_circle<Green>(rows);
    add_circle<Engineering>(rows);
    add_helix<Engineering>(rows, 100);
    // the measure bears no more than 0.433 of the moment
    add_helix<Green>(rows, 100);
    add_helix<Quintic>(rows, 100);
    add_helix<QuinticEngineering>(rows, 50);
    add_frame<Green>(rows);
    add_frame<Engineering>(rows);
    return rows;
}

}  // namespace ancf::bench::one_step
