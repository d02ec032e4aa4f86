// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scene that several processes hold in parts: what its statics and its motion share.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/petsc/partition.hpp>
#include <ancf/petsc/solver.hpp>
#include <ancf/types.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ancf::petsc::detail {

/// What one process has of a beam: neighbouring elements.
template <class Element>
struct Run {
    Beam<Element> beam;  ///< its elements are those of the part
    double start;        ///< reference length of the beam before it, m
};

/// The parts of one scene. All calls are collective but part(), solver(), partition() and runs().
class DividedScene {
public:
    DividedScene(const DividedScene&) = delete;
    DividedScene& operator=(const DividedScene&) = delete;

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
    [[nodiscard]] const Partition& partition() const noexcept { return *partition_; }
    /// Returns the solver.
    [[nodiscard]] Solver& solver() noexcept { return solver_; }

    /// Returns what this process has of a beam of the whole scene.
    ///
    ///     for (const auto& run : statics.runs(beam))
    ///         surface.add(statics.part(), run.beam, section, 9, run.start);
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

protected:
    DividedScene(Scene& model, MPI_Comm comm, const SolverOptions& options);
    ~DividedScene() = default;

    /// Calls a function that says whether to go on; one process that says no, or throws, ends all.
    [[nodiscard]] bool all_go_on(const std::function<bool()>& call) const;
    /// Gives a fault its element's number in the whole scene, and every process the message of the
    /// one that knows most.
    void settle(std::optional<Fault>& fault, std::string& message) const;

    Scene& model_;
    std::shared_ptr<const Partition> partition_;
    std::unique_ptr<Scene> part_;
    Solver solver_;
};

}  // namespace ancf::petsc::detail

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/divided_scene.ipp>  // IWYU pragma: export
#endif
