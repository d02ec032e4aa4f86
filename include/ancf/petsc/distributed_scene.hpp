// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static equilibrium and motion of one scene by several processes.
///
///     ancf::Model model = ...;                      // the same in every process
///     ancf::petsc::DistributedScene scene(model, PETSC_COMM_WORLD);
///     const auto report = scene.solve();            // in every process
///     scene.gather();                               // model.state() is the solution
///
/// The work is that of solve_statics and of GeneralizedAlpha: the same steps, tests and reports.
/// docs/petsc.md says what a process holds and what it tells the others.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/petsc/partition.hpp>
#include <ancf/petsc/solver.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ancf::petsc {

/// What one process has of a beam: neighbouring elements.
template <class Element>
struct Run {
    Beam<Element> beam;  ///< its elements are those of the part
    double start;        ///< reference length of the beam before it, m
};

/// One scene, divided between processes. All calls are collective but part(), solver(),
/// partition() and runs().
///
/// Reports are the same in every process, with these exceptions: reactions and memory are of this
/// process's part; a fault has its element, by its number in the whole scene, where that is held;
/// `softened` is set where such an element is held. Users' functions see the state of the part.
/// Where one of them throws in one process, or a `progress` says stop, all end: others throw
/// std::runtime_error, or return Status::stopped.
class DistributedScene {
public:
    /// Divides the scene, which outlives this and is the same in every process.
    /// @param options  of the solver of K, or of M + h gamma D + h^2 beta K.
    /// @throws InvalidArgument for options that PETSc refuses, where PETSc does not run, or where a
    ///         support, load or constraint is on a vector that no element has.
    /// @throws std::runtime_error where it cannot be divided.
    explicit DistributedScene(Scene& model, MPI_Comm comm = PETSC_COMM_WORLD,
                              const SolverOptions& options = {});
    DistributedScene(const DistributedScene&) = delete;
    DistributedScene& operator=(const DistributedScene&) = delete;

    /// Brings the parts to equilibrium. Stability is not judged, and NewtonKind::automatic is
    /// iterated as NewtonKind::mixed.
    /// @throws InvalidArgument for options that cannot be meant.
    [[nodiscard]] StaticsReport solve(const StaticsOptions& options = {});

    /// Integrates from the parts' state to the schedule's end; solve leaves its factor as the time,
    /// so set part().state().time to the start of the motion after it. `observe` sees the energies
    /// of the whole scene, and may call gathered(). M alone is solved by stabilised bi-conjugate
    /// gradients, whose options have the prefix and "mass_".
    /// @param memory  of a run of the scene divided in the same way.
    /// @throws InvalidArgument for a scene with constraints, for options of the solver of M that
    ///         PETSc refuses, and as GeneralizedAlpha::integrate.
    [[nodiscard]] DynamicsReport integrate(const Schedule& schedule,
                                           const GeneralizedAlphaOptions& options = {},
                                           const Memory& memory = {});

    /// Writes the state of all parts to the whole scene of every process.
    void gather();

    /// Returns coordinates, rates or forces of the whole scene, in every process.
    /// @param of_part  of the coordinates of this process's part, such as its reactions.
    [[nodiscard]] VectorX gathered(const VectorX& of_part) const {
        return partition_->gather(of_part);
    }

    /// Returns the part of this process, with the numbers of all nodes.
    [[nodiscard]] Scene& part() noexcept { return *part_; }
    /// Returns who has which node.
    [[nodiscard]] const detail::Partition& partition() const noexcept { return *partition_; }
    /// Returns the solver.
    [[nodiscard]] Solver& solver() noexcept { return solver_; }

    /// Returns what this process has of a beam of the whole scene.
    ///
    ///     for (const auto& run : scene.runs(beam))
    ///         surface.add(scene.part(), run.beam, section, 9, run.start);
    /// @throws InvalidArgument for a type of element that came after the scene was divided.
    template <class Element>
    [[nodiscard]] std::vector<Run<Element>> runs(const Beam<Element>& beam) const {
        std::vector<Run<Element>> result;
        const auto& group = model_.group<Element>();
        double start = 0.0;
        int before = -1;  // of the element before, its number in the part
        for (std::size_t k = 0; k < beam.elements.size(); ++k) {
            const int here = partition_->number_in_part(group, beam.elements[k]);
            if (here >= 0 && before < 0)
                result.push_back({{{{beam.nodes[k]}, {}, beam.prototypes}}, start});
            if (here >= 0) {
                result.back().beam.elements.push_back(here);
                result.back().beam.nodes.push_back(beam.nodes[k + 1]);
            }
            start += group.element(beam.elements[k]).length();
            before = here;
        }
        return result;
    }

    /// Writes what each process shows: FOLDER/NAME_0.vtu and so on, of those that show something,
    /// and FOLDER/NAME.pvtu, which lists them for ParaView.
    /// @param file     FOLDER/NAME.pvtu; the folder is there, and the same for all processes.
    /// @param surface  of this process, made from its part.
    /// @param time     s; stored with each piece.
    /// @throws InvalidArgument for another extension, or a file that cannot be written; where that
    ///         is so in one process alone the others throw std::runtime_error.
    void write_vtk(const std::filesystem::path& file, const Surface& surface,
                   double time = 0.0) const;

private:
    [[nodiscard]] bool all_go_on(const std::function<bool()>& call) const;
    void settle(std::optional<Fault>& fault, std::initializer_list<std::string*> texts) const;

    Scene& model_;
    std::string prefix_;
    std::shared_ptr<const detail::Partition> partition_;
    std::unique_ptr<Scene> part_;
    Solver solver_;
};

}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/distributed_scene.ipp>  // IWYU pragma: export
#endif
