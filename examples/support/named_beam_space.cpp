// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/model/builders/curve.hpp>

#include <support/with_element.hpp>

namespace examples {

template NamedBeam straight_beam(ancf::Model&, const BeamOptions&, int);
template NamedBeam straight_beam(ancf::Model&, const BeamOptions&, const ancf::Material&,
                                 const ancf::Section&, const ancf::Vector<double, 3>&,
                                 const ancf::Vector<double, 3>&, int);
template void check<3>(const BeamOptions&);

NamedBeam arc(ancf::Model& model, const BeamOptions& options, double radius, double angle,
              int elements) {
    return with_element<3>(options, [&](auto type) {
        using Element = typename decltype(type)::Element;
        return named(ancf::arc<Element>(model, options.material(), options.section(), {0, 0, 0},
                                        {1, 0, 0}, {0, 1, 0}, radius, angle, elements,
                                        element_options<typename Element::Options>(options)));
    });
}

}  // namespace examples
