// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/schedule.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/section/profiles.hpp>

#include <assembly/element_groups.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace threads_test {

using namespace ancf;
using Scene = Model;

constexpr int beam_elements = 1100;  // several runs of each colour, the last one incomplete

/// A long beam with a cable along it; both share every fourth node of the beam.
Scene make_scene() {
    Scene scene;
    const auto material = Material::isotropic(2e9, 0.3, 1200.0);
    const auto beam = straight_beam<CrossSectionBeam<3>>(scene, material, rectangle(0.1, 0.2),
                                                         {0, 0, 0}, {110, 0, 0}, beam_elements);
    const int cable = scene.add_prototype(Cable<3>(material, rectangle(0.01, 0.01), 0.4));
    for (int k = 0; k + 4 <= beam_elements; k += 4)
        scene.connect<Cable<3>>(cable, beam.node(k), beam.node(k + 4));
    scene.clamp(beam.first());
    scene.set_gravity({0.0, -9.81, 0.0});
    return scene;
}

struct Evaluated {
    double energy;
    VectorX force;
    std::vector<double> tangent;
};

Evaluated evaluate_on(int threads, const Scene& scene, const VectorX& q) {
#if defined(_OPENMP)
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
#else
    static_cast<void>(threads);
#endif
    Assembly assembly(scene, Storage::lower);
    const VectorX rest = VectorX::Zero(q.size());
    const auto fault = assembly.evaluate({q, rest, VectorX(), {}}, Request::tangent);
#if defined(_OPENMP)
    omp_set_num_threads(before);
#endif
    REQUIRE_FALSE(fault);
    const SparseMatrix& tangent = assembly.tangent();
    return {assembly.strain_energy(), assembly.internal_force(),
            std::vector<double>(tangent.valuePtr(), tangent.valuePtr() + tangent.nonZeros())};
}

/// A lattice: members attached to joints that several runs share.
Scene make_lattice() {
    constexpr int n = 9;
    std::vector<Vector<double, 3>> points;
    std::vector<Member> members;
    const auto place = [](int i, int j, int k) { return i + n * (j + n * k); };
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                points.emplace_back(i, j, k);
                if (i > 0) members.push_back({place(i - 1, j, k), place(i, j, k)});
                if (j > 0) members.push_back({place(i, j - 1, k), place(i, j, k)});
                if (k > 0) members.push_back({place(i, j, k - 1), place(i, j, k)});
            }
    Scene scene;
    const auto frame = ancf::frame<CrossSectionBeam<3>>(
        scene, {{Material::isotropic(2e9, 0.3, 1200.0), rectangle(0.1, 0.2)}}, points, members);
    scene.clamp(frame.joints[0]);
    return scene;
}

TEST_CASE("Assembly: one, two and three threads give the same bits", "[assembly]") {
    const bool lattice = GENERATE(false, true);
    CAPTURE(lattice);
    const Scene scene = lattice ? make_lattice() : make_scene();
    test::Random random(11);
    VectorX q = scene.state().q;
    for (double& value : q) value += random.uniform(-0.01, 0.01);
    scene.dependence().complete(q);
    const Evaluated serial = evaluate_on(1, scene, q);
    CHECK(serial.energy > 0.0);
    CHECK(serial.force.squaredNorm() > 0.0);
    for (const int threads : {2, 3}) {
        const Evaluated shared = evaluate_on(threads, scene, q);
        CAPTURE(threads);
        CHECK(shared.energy == serial.energy);
        CHECK((shared.force.array() == serial.force.array()).all());
        CHECK(shared.tangent == serial.tangent);
    }
}

TEST_CASE("Assembly: elements with a prototype of their own give what they gave sharing one",
          "[assembly]") {
    Scene scene = make_scene();
    test::Random random(7);
    VectorX q = scene.state().q;
    for (double& value : q) value += random.uniform(-1e-3, 1e-3);
    const Evaluated shared = evaluate_on(1, scene, q);
    const auto difference = [&] {
        const Evaluated own = evaluate_on(1, scene, q);
        double largest = std::abs(own.energy / shared.energy - 1.0);
        largest = std::max(largest, (own.force - shared.force).norm() / shared.force.norm());
        const auto tangent = [](const Evaluated& at) {
            return Eigen::Map<const VectorX>(at.tangent.data(),
                                             static_cast<Eigen::Index>(at.tangent.size()));
        };
        return std::max(largest, (tangent(own) - tangent(shared)).norm() / tangent(shared).norm());
    };
    for (const int element : {0, 3, 4, 127, 500, beam_elements - 1})
        CHECK(scene.make_own_prototype<CrossSectionBeam<3>>(element) > 0);
    CHECK(difference() <= 1e-14);  // round-off of packs that begin elsewhere
    scene.prototype<CrossSectionBeam<3>>(scene.make_own_prototype<CrossSectionBeam<3>>(500)) =
        CrossSectionBeam<3>(Material::isotropic(1e9, 0.3, 1200.0), rectangle(0.1, 0.2), 0.1);
    CHECK(difference() > 1e-6);
}

TEST_CASE("ElementSchedule: runs of one colour share no node and cover every element once",
          "[assembly]") {
    const Scene scene = make_scene();
    CHECK(scene.groups().size() == 2);
    for (const auto& group : scene.groups()) {
        const int count = group->size();
        const ElementSchedule schedule(group->connections, scene.layout().nodes());
        CHECK(schedule.colours().size() == (count > ElementSchedule::run_length ? 2U : 1U));
        std::vector<int> times(static_cast<std::size_t>(count), 0);
        int wrong = 0;
        std::size_t run = 0;
        for (const std::size_t end : schedule.colours()) {
            std::vector<int> owner(static_cast<std::size_t>(scene.layout().nodes()), -1);
            for (; run < end; ++run)
                for (int k = schedule.runs()[run].first; k < schedule.runs()[run].last; ++k) {
                    ++times[static_cast<std::size_t>(k)];
                    const Connection& c = group->connections[static_cast<std::size_t>(k)];
                    for (const NodeId node : {c.first, c.second}) {
                        int& own = owner[static_cast<std::size_t>(node.index)];
                        wrong += own >= 0 && own != static_cast<int>(run) ? 1 : 0;
                        own = static_cast<int>(run);
                    }
                }
        }
        CHECK(wrong == 0);
        CHECK(std::count(times.begin(), times.end(), 1) == count);
    }
}

#if defined(_OPENMP)
TEST_CASE("ElementSchedule: two threads run", "[assembly]") {
    const Scene scene = make_scene();
    const ElementGroup& beams = *scene.groups()[0];
    const ElementSchedule schedule(beams.connections, scene.layout().nodes());
    const int before = omp_get_max_threads();
    omp_set_num_threads(2);
    std::atomic<int> second{0};
    static_cast<void>(schedule.sum([&](const ElementRun&, std::size_t) {
        if (omp_get_thread_num() == 1) ++second;
        return 0.0;
    }));
    omp_set_num_threads(before);
    CHECK(second > 0);
}
#endif

TEST_CASE("ElementSchedule: what an element throws reaches the caller", "[assembly]") {
    const Scene scene = make_scene();
    for (const auto& group : scene.groups()) {
        const ElementSchedule schedule(group->connections, scene.layout().nodes());
        const auto failing = [](const ElementRun& run, std::size_t) -> double {
            throw std::runtime_error("element " + std::to_string(run.first));
        };
        CHECK_THROWS_WITH(schedule.sum(failing), "element 0");
    }
}

}  // namespace threads_test
