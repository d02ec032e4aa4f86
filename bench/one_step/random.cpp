// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>

#include <one_step/elements.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace ancf::bench::one_step {

Problem random_problem(unsigned seed, const std::string& element, std::string& name) {
    const bool rope = element == "rope", cable = element == "cable" || rope;
    std::mt19937 source(seed);
    const auto uniform = [&source](double low, double high) {
        // not std::uniform_real_distribution, which differs between standard libraries
        return low + (high - low) * (static_cast<double>(source()) / 4294967296.0);
    };
    const auto pick = [&](const std::vector<int>& of) {
        return of[static_cast<std::size_t>(uniform(0.0, static_cast<double>(of.size())))];
    };
    const auto direction = [&] {
        const double z = uniform(-1.0, 1.0), angle = uniform(0.0, 2.0 * pi);
        const double r = std::sqrt(1.0 - z * z);
        return Point(z, r * std::cos(angle), r * std::sin(angle));
    };
    const bool engineering = uniform(0.0, 1.0) < 0.5;
    const bool curved = uniform(0.0, 1.0) < 0.4 && !cable;
    const int elements = pick({8, 12, 16, 24, 32}), drawn = pick({1, 1, 2, 3});
    const int loads = cable ? 1 : drawn;
    const double height = std::pow(10.0, uniform(-3.0, -1.0)), factor = uniform(1.0, 3.0);
    const double width = cable ? height : height * factor;
    const double angle = uniform(0.2, 1.5);
    const double young = 12.0 / (width * height * height * height);  // the smaller E I = 1
    const double force = std::pow(10.0, uniform(-0.3, 1.5)), moment = uniform(0.3, 4.0);
    const Point force_along = direction(), moment_about = direction();
    Problem p;
    const auto build = [&](auto type) {
        using Element = decltype(type);
        const auto material = Material::isotropic(young, 0.3, 1.0);
        const auto section = rectangle(width, height);
        using Type = typename Element::type;
        const auto best = best_options<Type>();
        const auto beam = curved ? arc<Type>(p.scene, material, section, {0, 0, 0}, {1, 0, 0},
                                             {0, 1, 0}, 1.0 / angle, angle, elements, best)
                                 : straight_beam<Type>(p.scene, material, section, {0, 0, 0},
                                                       {1, 0, 0}, elements, best);
        p.end = beam.last();
        if (!rope) {
            p.scene.clamp(beam.first(), clamp_of<Type>);
            return;
        }
        p.scene.pin(beam.first());
        p.scene.pin(beam.last());
        p.end = beam.node(1 + static_cast<int>(uniform(0.0, elements - 1.0)));
        if (engineering) add_line_load(p.scene, beam, Point(force * force_along));
    };
    struct OfCable {
        using type = Cable;
    };
    struct OfGreen {
        using type = Green;
    };
    struct OfEngineering {
        using type = Engineering;
    };
    struct OfContinuum {
        using type = Continuum;
    };
    if (element == "continuum")
        build(OfContinuum());
    else if (cable)
        build(OfCable());
    else if (engineering)
        build(OfEngineering());
    else
        build(OfGreen());
    const bool along = rope && engineering;  // a force per length
    if ((loads & 1) != 0 && !along) p.scene.add(Force<3>(p.end, force * force_along));
    if ((loads & 2) != 0) p.scene.add(Moment(p.end, moment * moment_about));
    const std::string measured = engineering ? "engineering" : "green";
    name = (element.empty() ? measured : element) + std::string(curved ? " arc" : " line") +
           ", n " + std::to_string(elements) + ", h " + std::to_string(height) + ", b/h " +
           std::to_string(width / height) +
           ((loads & 1) != 0 ? ", force " + std::to_string(force) : "") +
           ((loads & 2) != 0 ? ", moment " + std::to_string(moment) : "");
    return p;
}

}  // namespace ancf::bench::one_step
