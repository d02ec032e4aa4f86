// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// One call to equilibrium: iterations of scenes on which Newton's method in one load step breaks.
///
///     one_step                         every scene, by every way of correcting
///     one_step --newton automatic      by the default alone
///     one_step --case elastica         the scenes whose names begin so
///     one_step --iterates              strains and pivots of the iterates of one load step
///     one_step --random 400            random cantilevers instead, each against sixty small steps
///     one_step --random 400 --element continuum    the same of continuum beams, or `cable`;
///                                  `rope`: a cable between two pins, under a force at a node or
///                                  per length
///
/// Iterations count rejected steps. `error` is the distance of the loaded end from theory, or from
/// a run in many small steps, over the length; nothing where neither is there.

#include <ancf/assembly/assembly.hpp>
#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/solver/turning.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using ancf::NewtonKind;
using ancf::pi;
using Point = ancf::Vector<double, 3>;
using Green = ancf::CrossSectionBeam<3, ancf::Geodesic>;
using Engineering =
    ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>;
using Quintic = ancf::QuinticBeam<>;
using QuinticEngineering = ancf::QuinticBeam<ancf::EngineeringMeasure>;
using ancf::TorsionBeam;
using Continuum = ancf::ContinuumBeam<3>;
using Cable = ancf::Cable<3>;

/// What holds a beam without shear is its slope too.
template <class Element>
inline constexpr ancf::Clamp clamp_of =
    std::is_same_v<Element, TorsionBeam> || std::is_same_v<Element, Cable>
        ? ancf::Clamp::full
        : ancf::Clamp::free_slope;

/// The best options of an element that has some, else the usual ones.
template <class Element>
typename Element::Options best_options() {
    if constexpr (std::is_same_v<Element, Continuum> || std::is_same_v<Element, Cable>)
        return {};
    else
        return Element::Options::best();
}

/// A scene that waits for its solution, and its loaded end.
struct Problem {
    ancf::Model scene;
    ancf::NodeId end;
};

/// A row of the table.
struct Row {
    std::string name;
    int steps;
    std::function<Problem()> make;
    bool has_theory = false;
    Point theory = Point::Zero();
    double length = 1.0;
};

ancf::StaticsReport solve(ancf::Model& scene, NewtonKind newton, int steps, bool adaptive) {
    ancf::StaticsOptions options;
    options.newton = newton;
    options.steps = steps;
    options.adaptive = adaptive;
    ancf::EigenLu solver;
    return ancf::solve_statics(scene, solver, options);
}

template <class Element>
std::string measure() {
    if (std::is_same_v<Element, Engineering>) return "engineering";
    if (std::is_same_v<Element, QuinticEngineering>) return "quintic, engineering";
    if (std::is_same_v<Element, TorsionBeam>) return "torsion beam";
    if (std::is_same_v<Element, Continuum>) return "continuum beam";
    if (std::is_same_v<Element, Cable>) return "cable";
    return std::is_same_v<Element, Quintic> ? "quintic" : "green";
}

/// A cantilever of length 1 and height h, loaded at `angle` to the axes of its section.
template <class Element>
Problem cantilever(double height, int elements, const Point& force, const Point& moment) {
    Problem p;
    const double young = 12.0 / std::pow(height, 4);  // E I = 1
    const auto beam = ancf::straight_beam<Element>(
        p.scene, ancf::Material::isotropic(young, 0.3, 1.0), ancf::rectangle(height, height),
        {0, 0, 0}, {1, 0, 0}, elements, best_options<Element>());
    p.scene.clamp(beam.first(), clamp_of<Element>);
    if (force.norm() > 0.0) p.scene.add(ancf::Force<3>(beam.last(), force));
    if (moment.norm() > 0.0) p.scene.add(ancf::Moment(beam.last(), moment));
    p.end = beam.last();
    return p;
}

template <class Element>
void add_elastica(std::vector<Row>& rows) {
    const ancf::Vector<double, 2> tip(0.445004402246, 0.810609024880);  // inextensible, under 10
    for (const double load : {10.0, 100.0})
        for (const double height : {1e-1, 1e-2, 1e-3})
            for (const int steps : {1, 5, 20}) {
                // Green's strain has no equilibrium there: the clamp is crushed
                constexpr bool green = std::is_same_v<Element, Green> ||
                                       std::is_same_v<Element, Continuum> ||
                                       std::is_same_v<Element, Cable>;
                if (green && load > 50.0 && height > 0.05) continue;
                const Point across(0.0, std::cos(0.6), std::sin(0.6));
                Row row{"elastica " + std::to_string(std::lround(load)) + ", h/L 1/" +
                            std::to_string(std::lround(1.0 / height)) + ", " + measure<Element>(),
                        steps, [load, height, across] {
                            return cantilever<Element>(height, 32, load * across, Point::Zero());
                        }};
                row.has_theory = load == 10.0;
                row.theory = Point(tip[0], tip[1] * across[1], tip[1] * across[2]);
                rows.push_back(row);
            }
}

/// A bend of 45 degrees under 600, for whose section `theory` holds.
template <class Element>
void add_bends(std::vector<Row>& rows, const std::string& what,
               const typename Element::Options& options, const Point& theory) {
    for (const int elements : {8, 16, 32}) {
        Row row{"bend 45, " + std::to_string(elements) + " elements, " + what,
                1,
                [elements, options] {
                    Problem p;
                    const auto beam = ancf::arc<Element>(
                        p.scene, ancf::Material::from_moduli(1e7, 5e6, 1.0),
                        ancf::rectangle(1.0, 1.0).with_shear_correction(1.0, 1.0), {0, 0, 0},
                        {1, 0, 0}, {0, 1, 0}, 100.0, 0.25 * pi, elements, options);
                    p.scene.clamp(beam.first(), clamp_of<Element>);
                    p.scene.add(ancf::Force<3>(beam.last(), {0, 0, 600}));
                    p.end = beam.last();
                    return p;
                },
                true,
                theory,
                100.0};
        rows.push_back(row);
    }
}

template <class Element>
void add_bends(std::vector<Row>& rows) {
    add_bends<Element>(rows, measure<Element>(), Element::Options::best(),
                       Point(46.89192495, 15.55778591, 53.60736918));
}

/// The bend of the paper's element, by its own section and rule.
void add_paper_bends(std::vector<Row>& rows) {
    using Projecting = ancf::CrossSectionBeam<3>;
    add_bends<Projecting>(rows, "projected, paper", Projecting::Options(),
                          Point(47.150438573629, 15.684800534039, 53.474858791825));
}

/// A full circle by an end moment at 0.7 rad to the axes.
template <class Element>
void add_circle(std::vector<Row>& rows) {
    for (const double slenderness : {28.0, 100.0})
        for (const int steps : {1, 10}) {
            const Point axis(0.0, -std::sin(0.7), std::cos(0.7));
            rows.push_back({"circle, h/L 1/" + std::to_string(std::lround(slenderness)) + ", " +
                                measure<Element>(),
                            steps,
                            [slenderness, axis] {
                                return cantilever<Element>(1.0 / slenderness, 32, Point::Zero(),
                                                           2.0 * pi * axis);
                            },
                            std::is_same_v<Element, Engineering>});
        }
}

/// Ibrahimbegovic's helix of ten turns by the options best() alone.
template <class Element>
void add_helix(std::vector<Row>& rows, int elements) {
    rows.push_back(
        {"helix, " + std::to_string(elements) + " elements, " + measure<Element>(), 100,
         [elements] {
             Problem p;
             ancf::Moments moments;
             moments.area = 1.0;
             moments.yy = moments.zz = 0.01;
             const auto section = ancf::Section::from_moments(moments)
                                      .with_shear_correction(1.0, 1.0)
                                      .with_torsion_constant(0.01);
             const auto beam = ancf::straight_beam<Element>(
                 p.scene, ancf::Material::from_moduli(1e4, 1e4, 1.0), section, {0, 0, 0},
                 {10, 0, 0}, elements, Element::Options::best());
             p.scene.clamp(beam.first(), clamp_of<Element>);
             p.scene.add(ancf::Moment(beam.last(), {0, 0, 200.0 * pi}));
             p.scene.add(ancf::Force<3>(beam.last(), {0, 0, 50.0}));
             p.end = beam.last();
             return p;
         },
         std::is_same_v<Element, Engineering> || std::is_same_v<Element, QuinticEngineering>,
         Point(0.004803250, 0.000072497, -0.076441742), 10.0});
}

/// Three beams welded around two corners.
template <class Element>
void add_frame(std::vector<Row>& rows) {
    rows.push_back({"frame 0.01 x 0.06, " + measure<Element>(), 4, [] {
                        Problem p;
                        const auto steel = ancf::Material::isotropic(2.1e11, 0.3, 7850.0);
                        const auto section = ancf::rectangle(0.01, 0.06);
                        const Point corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0.8}};
                        ancf::NodeId last;
                        for (int leg = 0; leg < 3; ++leg) {
                            const auto beam = ancf::straight_beam<Element>(
                                p.scene, steel, section, corners[leg], corners[leg + 1], 8,
                                best_options<Element>());
                            if (leg == 0)
                                p.scene.clamp(beam.first());
                            else
                                p.scene.add(ancf::Weld(p.scene, last, beam.first()));
                            last = beam.last();
                        }
                        p.scene.add(ancf::Force<3>(last, {3000, 2000, 1500}));
                        p.end = last;
                        return p;
                    }});
}

std::vector<Row> all_rows() {
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
    add_elastica<TorsionBeam>(rows);
    add_bends<TorsionBeam>(rows);
    add_circle<TorsionBeam>(rows);
    add_frame<TorsionBeam>(rows);
    add_elastica<Continuum>(rows);
    add_circle<Continuum>(rows);
    add_frame<Continuum>(rows);
    add_elastica<Cable>(rows);
    return rows;
}

const std::vector<std::pair<std::string, NewtonKind>>& kinds() {
    static const std::vector<std::pair<std::string, NewtonKind>> all = {
        {"plain", NewtonKind::plain},
        {"mixed", NewtonKind::mixed},
        {"turned", NewtonKind::turned},
        {"automatic", NewtonKind::automatic}};
    return all;
}

void print(const Row& row, const std::string& newton, const ancf::StaticsReport& report,
           const Problem& problem) {
    std::cout << "| " << row.name << " | " << row.steps << " | " << newton << " | "
              << report.iterations() << " | " << report.steps.size() << " | "
              << to_string(report.status);
    if (report.status != ancf::Status::converged) std::cout << " at " << report.factor;
    std::cout << " | ";
    if (row.has_theory && report.status == ancf::Status::converged)
        std::cout << (problem.scene.position(problem.end) - row.theory).norm() / row.length;
    std::cout << " |" << std::endl;
}

/// A cantilever that a seed draws: straight or an arc, under a force, a moment or both. A cable is
/// straight, since a curved one spins freely, has a square section and takes a force. A rope is a
/// cable between two pins, under a force somewhere or a force per length.
/// @param element  "continuum", "cable", "rope", or else either measure of beams with sections
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
        const auto material = ancf::Material::isotropic(young, 0.3, 1.0);
        const auto section = ancf::rectangle(width, height);
        using Type = typename Element::type;
        const auto best = best_options<Type>();
        const auto beam = curved ? ancf::arc<Type>(p.scene, material, section, {0, 0, 0}, {1, 0, 0},
                                                   {0, 1, 0}, 1.0 / angle, angle, elements, best)
                                 : ancf::straight_beam<Type>(p.scene, material, section, {0, 0, 0},
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
    if ((loads & 1) != 0 && !along) p.scene.add(ancf::Force<3>(p.end, force * force_along));
    if ((loads & 2) != 0) p.scene.add(ancf::Moment(p.end, moment * moment_about));
    const std::string measured = engineering ? "engineering" : "green";
    name = (element.empty() ? measured : element) + std::string(curved ? " arc" : " line") +
           ", n " + std::to_string(elements) + ", h " + std::to_string(height) + ", b/h " +
           std::to_string(width / height) +
           ((loads & 1) != 0 ? ", force " + std::to_string(force) : "") +
           ((loads & 2) != 0 ? ", moment " + std::to_string(moment) : "");
    return p;
}

/// Prints the largest strains, axial and of the section in its plane, and the tangent's negative
/// pivots in the iterates of the elastica under 10 E I/L^2.
template <class Element>
void print_iterates(bool mixed, bool turned) {
    Problem p = cantilever<Element>(0.01, 32, 10.0 * Point(0.0, std::cos(0.6), std::sin(0.6)),
                                    Point::Zero());
    ancf::EigenLdlt solver;
    ancf::Assembly assembly(p.scene, solver.storage());
    solver.analyze(assembly.tangent());
    ancf::Turning turning(p.scene, assembly.numbering());
    ancf::VectorX& q = p.scene.state().q;
    const ancf::VectorX rest = ancf::VectorX::Zero(q.size());
    ancf::VectorX residual, x;
    ancf::Correction last;
    for (int iterate = 0; iterate < 7; ++iterate) {
        if (assembly.evaluate({q, rest, ancf::VectorX(), {1.0, 1.0}}, ancf::Request::tangent,
                              nullptr, mixed && iterate > 0 ? &last : nullptr))
            return;
        double axial = 0.0, stretch = 0.0, shear = 0.0;
        const auto larger = [](double a, double b) { return std::abs(b) > std::abs(a) ? b : a; };
        const auto& group = p.scene.group<Element>();
        for (int k = 0; k < group.size(); ++k)
            for (const double xi : {0.0, 0.5, 1.0}) {
                const auto e = p.scene.element_coordinates<Element>(k);
                axial = larger(axial, group.element(k).strains(e, xi)[0]);
                const auto across = group.element(k).transverse_strains(e, xi);
                stretch = larger(stretch, across[0]);
                shear = larger(shear, across[2]);
            }
        const auto factors = solver.factorize(assembly.tangent());
        std::cout << "| " << (turned ? "turned by the tangent" : "added") << " | "
                  << measure<Element>() << ", " << (mixed ? "mixed" : "plain") << " | " << iterate
                  << " | " << axial << " | " << stretch << " | " << shear << " | "
                  << factors.negative_pivots << " |\n";
        assembly.residual(residual);
        solver.solve(residual, x);
        last.before = q;
        assembly.numbering().add_free(x, -1.0, q);
        last.change = q - last.before;
        if (turned)
            turning.turn(last.before, last.change, q, ancf::TurnBy::tangent);
        else if (mixed)
            turning.twist(last.before, last.change, q);
    }
}

/// Prints where each attempt of a run went, how it ended and how large its corrections were.
void print_attempts(const ancf::StaticsReport& report) {
    for (const ancf::LoadStep& step : report.steps) {
        std::cout << "     " << step.factor << ' ' << to_string(step.status) << ':';
        for (const double correction : step.corrections) std::cout << ' ' << correction;
        std::cout << std::endl;
    }
}

int run_random(int count, unsigned seed, const std::string& element, const std::string& only,
               bool check, bool verbose) {
    int wrong = 0, solved = 0;
    std::vector<std::vector<double>> iterations(kinds().size());
    std::vector<int> elsewhere(kinds().size());
    for (int k = 0; k < count; ++k) {
        std::string name;
        const unsigned own = seed + static_cast<unsigned>(k);
        Problem slow = random_problem(own, element, name);
        bool followed = false;
        if (check)
            followed =
                solve(slow.scene, NewtonKind::plain, 60, true).status == ancf::Status::converged;
        if (check && !followed) {
            std::cout << own << ' ' << name << ": sixty steps fail\n";
            continue;
        }
        ++solved;
        for (std::size_t n = 0; n < kinds().size(); ++n) {
            if (!only.empty() && only != kinds()[n].first) continue;
            Problem p = random_problem(own, element, name);
            const auto report = solve(p.scene, kinds()[n].second, 1, false);
            if (report.status == ancf::Status::converged)
                iterations[n].push_back(report.iterations());
            const double off =
                followed ? (p.scene.state().q - slow.scene.state().q).lpNorm<Eigen::Infinity>()
                         : 0.0;
            const bool other = report.status == ancf::Status::converged && off > 1e-5;
            if (other) ++elsewhere[n];
            const bool failed = report.status != ancf::Status::converged;
            if (verbose || other || (!only.empty() && failed)) {
                std::cout << own << ' ' << kinds()[n].first << ' ' << name << ": "
                          << report.iterations() << " iterations, " << report.steps.size()
                          << " steps, " << to_string(report.status);
                if (report.status != ancf::Status::converged) std::cout << " at " << report.factor;
                if (other) std::cout << ", elsewhere by " << off;
                std::cout << std::endl;
                if (verbose) print_attempts(report);
            }
        }
    }
    for (std::size_t n = 0; n < kinds().size(); ++n) {
        if (!only.empty() && only != kinds()[n].first) continue;
        auto& all = iterations[n];
        std::sort(all.begin(), all.end());
        std::cout << kinds()[n].first << ": " << all.size() << " of " << solved << " converged, "
                  << elsewhere[n] << " elsewhere";
        if (!all.empty())
            std::cout << "; iterations " << all[all.size() / 2] << " in the median, "
                      << all[all.size() * 9 / 10] << " at nine tenths, " << all.back()
                      << " at most";
        std::cout << '\n';
        wrong += elsewhere[n];
    }
    return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Iterations to equilibrium in one call.");
    std::string newton, name, element;
    int random = 0;
    unsigned seed = 1;
    bool iterates = false, no_check = false, verbose = false, quick = false;
    app.add_option("--newton", newton, "plain, mixed, turned or automatic; none: all");
    app.add_option("--case", name, "beginning of a name");
    app.add_flag("--iterates", iterates, "of one load step");
    app.add_option("--random", random, "number of random cantilevers");
    app.add_option("--element", element, "continuum, cable or rope; none: beams with sections")
        ->check(CLI::IsMember({"continuum", "cable", "rope"}));
    app.add_option("--seed", seed, "of the first of them");
    app.add_flag("--no-check", no_check, "do not compare them with sixty small steps");
    app.add_flag("--verbose", verbose, "print each of them, and the corrections of each attempt");
    app.add_flag("--quick", quick, "a few of all");
    CLI11_PARSE(app, argc, argv);
    if (random > 0) return run_random(random, seed, element, newton, !no_check, verbose);
    if (iterates) {
        std::cout
            << "| corrections | tangent | iterate | axial | e_yy | 2e_yz | negative pivots |\n"
               "|---|---|---|---|---|---|---|\n";
        for (const bool turned : {false, true})
            for (const bool mixed : {false, true}) {
                print_iterates<Green>(mixed, turned);
                print_iterates<Engineering>(mixed, turned);
            }
        return 0;
    }
    std::cout << "| scene | steps | newton | iterations | tried | status | error |\n"
                 "|---|---|---|---|---|---|---|\n";
    for (const Row& row : all_rows()) {
        if (row.name.compare(0, name.size(), name) != 0) continue;
        for (const auto& [word, kind] : kinds()) {
            if (!newton.empty() && newton != word) continue;
            Problem problem = row.make();
            const auto report = solve(problem.scene, kind, row.steps, false);
            print(row, word, report, problem);
        }
        if (quick) break;
    }
    return 0;
}
