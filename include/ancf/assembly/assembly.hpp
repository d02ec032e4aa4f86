// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The system of a scene: forces, tangent and mass, scattered into one fixed sparse pattern.
///
/// Unknowns are the free coordinates and the multipliers. In the notation of docs/notation.md:
///
///     residual = (Q_e(q) + G^T lambda - Q(q, v, t), g(q, t)),
///     tangent  = [K - dQ/dq + (G^T lambda)_q, G^T; G, 0].
///
/// The order of summation is fixed, so equal input gives equal bits.

#pragma once

#include <ancf/assembly/block_pattern.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/assembly/schedule.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/error.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// Where a scene is evaluated.
struct Configuration {
    const VectorX& q;            ///< all coordinates
    const VectorX& v;            ///< their rates
    const VectorX& multipliers;  ///< of all constraints
    Instant instant;             ///< time, or load factor
};

/// What an evaluation computes.
enum class Request {
    force,               ///< energies, forces, constraint violations
    tangent,             ///< and the tangent
    tangent_and_damping  ///< and the derivative with respect to the rates
};

/// The last step of Newton's method, all coordinates.
struct Correction {
    VectorX before;  ///< where its tangent was taken
    VectorX change;  ///< what the linear system gave
};

/// An element whose energy, force or tangent is not a number.
struct Fault {
    Status status;  ///< degenerate or not_finite
    int group;      ///< place of the element's type in the model's list; -1: not an element
    int element;    ///< index in that group
};

namespace detail {

/// Whether an element has the tangent of mixed integration points.
template <class Element, class = void>
struct EvaluatesMixed : std::false_type {};
template <class Element>
struct EvaluatesMixed<Element, std::void_t<decltype(std::declval<const Element&>().evaluate(
                                   std::declval<const typename Element::Coordinates&>(),
                                   std::declval<const typename Element::Coordinates&>(),
                                   std::declval<const typename Element::Coordinates&>()))>>
    : std::true_type {};

template <class Element, class = void>
struct EvaluatesPacks : std::false_type {};
template <class Element>
struct EvaluatesPacks<Element, std::enable_if_t<Element::evaluates_packs>> : std::true_type {};

/// How many equal elements the assembler evaluates at once: as many as a wide register has lanes
/// where the element takes packs, else one.
template <class Element>
inline constexpr int pack_lanes = EvaluatesPacks<Element>::value ? wide_lanes : 1;

}  // namespace detail

/// Evaluates and assembles a model. The model outlives it; after a change of the model's elements,
/// supports, loads or constraints a new one is made.
template <class Scene>
class Assembly {
public:
    /// @throws InvalidArgument for a load or constraint on a vector that its node does not carry,
    ///         or for lower storage of a tangent that is not symmetric or has multipliers.
    Assembly(const Scene& model, Storage storage);

    /// Returns the scene.
    [[nodiscard]] const Scene& model() const noexcept { return model_; }
    /// Returns the order of unknowns.
    [[nodiscard]] const Numbering& numbering() const noexcept { return numbering_; }
    /// Returns the places of entries.
    [[nodiscard]] const BlockPattern& pattern() const noexcept { return pattern_; }

    /// Evaluates the scene; results stand in the members below until the next evaluation.
    ///
    /// @param increment  where given, a change of all coordinates whose linear effect K increment
    ///                   is added to the internal force (prescribed motion enters this way).
    /// @param last       where given, the correction that led to q: elements that can then take the
    ///                   tangent of mixed integration points.
    /// @return the first element that failed, if one did; the results are then of no use.
    [[nodiscard]] std::optional<Fault> evaluate(const Configuration& at, Request request,
                                                const VectorX* increment = nullptr,
                                                const Correction* last = nullptr);

    // Results of the last evaluation; forces are of all coordinates, N and N m ----------------

    /// Returns the elastic force Q_e.
    [[nodiscard]] const VectorX& internal_force() const noexcept { return internal_; }
    /// Returns the loads Q, gravity included.
    [[nodiscard]] const VectorX& external_force() const noexcept { return external_; }
    /// Returns the force of the constraints, G^T lambda.
    [[nodiscard]] const VectorX& constraint_force() const noexcept { return constraint_; }
    /// Returns g of the constraints, one entry per equation; m where g is a length.
    [[nodiscard]] const VectorX& violation() const noexcept { return violation_; }
    /// Returns U, J.
    [[nodiscard]] double strain_energy() const noexcept { return strain_energy_; }

    /// Returns the potential of gravity and of the loads that have one, J.
    [[nodiscard]] double load_potential() const noexcept { return load_potential_; }
    /// Returns the tangent, in the pattern.
    [[nodiscard]] const SparseMatrix& tangent() const noexcept { return tangent_; }
    /// Returns -dQ/dv, in the pattern.
    [[nodiscard]] const SparseMatrix& damping() const noexcept { return damping_; }

    /// Returns the first element whose coordinates are not finite or not admissible.
    [[nodiscard]] std::optional<Fault> inspect(const VectorX& q) const;

    /// Writes the residual of the unknowns.
    void residual(VectorX& out) const;

    /// Returns g_t of dg/dt = G v + g_t, one entry per equation; m/s where g is a length.
    [[nodiscard]] const VectorX& violation_rate() const noexcept { return violation_rate_; }
    /// Returns c of d2g/dt2 = G a + c, one entry per equation; m/s^2 where g is a length.
    [[nodiscard]] const VectorX& convection() const noexcept { return convection_; }

    /// Returns the derivative of the external force with respect to the load factor, where the
    /// instant is that factor: N and N m.
    [[nodiscard]] VectorX load_rate(const VectorX& q, double factor) const;

    // Inertia, constant -----------------------------------------------------------------------

    /// Returns the mass matrix in the pattern of the tangent; zero for the multipliers.
    [[nodiscard]] SparseMatrix mass() const;

    /// Returns M a for a vector of all coordinates.
    [[nodiscard]] VectorX mass_product(const VectorX& a) const;

    /// Sets the driven coordinates of q to their values at an instant.
    void apply_supports(const Instant& instant, VectorX& q) const;

    /// Calls visit(element, coordinates, add) for every element, in order: `coordinates` are the
    /// indices of its nodal coordinates, add(block, matrix) scatters an element's square block into
    /// a matrix of this pattern. For integrators with element forces of their own.
    template <class Visitor>
    void for_each_element(Visitor&& visit) const {
        for_each_group([&](const auto& group, const auto& slots) {
            using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
            int coordinate[Element::dofs];
            for (std::size_t k = 0; k < slots.size(); ++k) {
                element_coordinates<Element>(slots[k], coordinate);
                visit(group.element(static_cast<int>(k)), coordinate,
                      [&](const auto& block, SparseMatrix& matrix) {
                          scatter<Element>(slots[k], block, matrix.valuePtr());
                      });
            }
        });
    }

private:
    // an element's place in the system
    struct Slots {
        std::array<int, 2> node;
        std::array<std::array<int, 2>, 2> base;  // [row node][column node], -1 if not stored
        bool plain;  // both nodes carry just the element's vectors and all of them are free
    };

    // values of the matrix from first to before last
    struct ValueRange {
        int first;
        int last;
    };

    void list_coordinates();
    void build_pattern(Storage storage);
    template <class Element>
    void build_slots(const ElementGroup<Element>& group);
    void build_clearing();
    void clear_values(const std::vector<ValueRange>& ranges);
    void build_gravity();
    [[nodiscard]] std::vector<int> coordinates_of(const Coupling& coupling, const char* what) const;

    template <class Element>
    void element_coordinates(const Slots& slots, int (&out)[Element::dofs]) const;

    template <class Element, class Block>
    void scatter(const Slots& slots, const Block& block, double* values) const;

    // Each adds elements and returns their energy: all of a group, one, or as many as a pack has
    // lanes, equal but for their coordinates.
    template <class Element>
    double add_elements(const ElementGroup<Element>& group, std::size_t index,
                        const Configuration& at, Request request, const VectorX* increment,
                        const Correction* last);
    template <class Element>
    double add_element(const Element& element, const Slots& slots, const Configuration& at,
                       Request request, const VectorX* increment, const Correction* last);
    template <int Lanes, class Element>
    double add_pack(const Element& element, const Slots* slots, const Configuration& at,
                    Request request);
    template <class Visitor>
    void for_each_load(const VectorX& q, const VectorX& v, double time, bool derivatives,
                       Visitor&& visit) const;
    void add_loads(const Configuration& at, Request request);
    void add_constraints(const Configuration& at, Request request);
    void add_constraint_blocks(int constraint, const ConstraintResult& result);
    void add_value(int row, int column, double value, SparseMatrix& matrix) const;

    // Calls visit(group, slots of the group) for each element type.
    template <class Visitor>
    void for_each_group(Visitor&& visit) const {
        std::size_t index = 0;
        model_.for_each_group([&](const auto& group) { visit(group, slots_[index++]); });
    }

    const Scene& model_;
    Numbering numbering_;
    BlockPattern pattern_;
    std::vector<std::vector<Slots>> slots_;                      // per group
    std::vector<ElementSchedule> schedules_;                     // per group
    std::vector<std::vector<std::vector<ValueRange>>> cleared_;  // per group and run
    std::vector<ValueRange> cleared_first_;                      // columns that no element adds to
    std::vector<std::vector<int>> load_coordinates_;
    std::vector<std::vector<int>> constraint_coordinates_;
    VectorX gravity_;  // force of gravity at unit scale

    VectorX internal_, external_, constraint_, violation_, violation_rate_, convection_;
    double strain_energy_ = 0.0;
    double load_potential_ = 0.0;
    SparseMatrix tangent_, damping_;
};

template <class Scene>
Assembly<Scene>::Assembly(const Scene& model, Storage storage) : model_(model), numbering_(model) {
    list_coordinates();
    if (storage == Storage::lower) {
        detail::require(
            model.constraints().empty(),
            "Assembly: constraints make the tangent indefinite; choose a solver of full "
            "storage such as Umfpack or EigenLu");
        for (const ScaledLoad& load : model.loads())
            detail::require(
                load.load.symmetric(),
                "Assembly: a load has an unsymmetric stiffness; choose a solver of full "
                "storage such as Umfpack or EigenLu");
    }
    build_pattern(storage);
    model.for_each_group([&](const auto& group) { build_slots(group); });
    build_clearing();
    build_gravity();
    tangent_ = pattern_.matrix();
}

template <class Scene>
std::vector<int> Assembly<Scene>::coordinates_of(const Coupling& coupling, const char* what) const {
    const Layout& layout = model_.layout();
    std::vector<int> coordinates;
    for (const NodeField& at : coupling) {
        const int first = layout.index(at);
        detail::require(first >= 0, "a ", what, " acts on ", to_string(at.field), " of node ",
                        at.node.index, ", which carries no such vector");
        for (int k = 0; k < layout.dimension(); ++k) coordinates.push_back(first + k);
    }
    return coordinates;
}

template <class Scene>
void Assembly<Scene>::list_coordinates() {
    for (const ScaledLoad& load : model_.loads())
        load_coordinates_.push_back(coordinates_of(load.load.coupling(), "load"));
    for (const AnyConstraint& constraint : model_.constraints())
        constraint_coordinates_.push_back(coordinates_of(constraint.coupling(), "constraint"));
}

template <class Scene>
void Assembly<Scene>::build_pattern(Storage storage) {
    std::vector<std::pair<int, int>> pairs;
    model_.for_each_group([&](const auto& group) {
        for (const Connection& c : group.connections)
            pairs.emplace_back(c.first.index, c.second.index);
    });
    std::vector<int> blocks;
    const auto couple_all = [&](const std::vector<int>& coordinates) {
        blocks.clear();
        for (const int k : coordinates) blocks.push_back(numbering_.block(k));
        std::sort(blocks.begin(), blocks.end());
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        for (std::size_t a = 0; a < blocks.size(); ++a)
            for (std::size_t b = a + 1; b < blocks.size(); ++b)
                pairs.emplace_back(blocks[a], blocks[b]);
    };
    for (std::size_t k = 0; k < load_coordinates_.size(); ++k)
        if (!model_.loads()[k].load.constant()) couple_all(load_coordinates_[k]);
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        couple_all(constraint_coordinates_[k]);
        for (const int block : blocks)
            pairs.emplace_back(block, numbering_.constraint_block(static_cast<int>(k)));
    }
    pattern_ = BlockPattern(numbering_.block_sizes(), std::move(pairs), storage);
}

template <class Scene>
template <class Element>
void Assembly<Scene>::build_slots(const ElementGroup<Element>& group) {
    static_assert(require_element<Element>());
    const Layout& layout = model_.layout();
    std::vector<Slots> all;
    all.reserve(group.connections.size());
    for (const Connection& c : group.connections) {
        Slots slots;
        slots.node = {c.first.index, c.second.index};
        slots.plain = true;
        for (std::size_t a = 0; a < 2; ++a) {
            const int node = slots.node[a];
            const int size = pattern_.first(node + 1) - pattern_.first(node);
            slots.plain =
                slots.plain && layout.fields(node) == Element::fields && size == Element::dofs / 2;
            for (std::size_t b = 0; b < 2; ++b)
                slots.base[a][b] =
                    pattern_.stored(node, slots.node[b]) ? pattern_.base(node, slots.node[b]) : -1;
        }
        all.push_back(slots);
    }
    slots_.push_back(std::move(all));
    schedules_.emplace_back(group.connections, layout.nodes());
}

// Each run clears the columns of the nodes that no run before it touched, just before it adds to
// them: they come from memory once, and threads share that work too.
template <class Scene>
void Assembly<Scene>::build_clearing() {
    const int nodes = model_.layout().nodes();
    std::vector<char> seen(static_cast<std::size_t>(nodes), 0);
    const auto append = [&](int block, std::vector<ValueRange>& ranges) {
        const ValueRange next{pattern_.first_value(block), pattern_.first_value(block + 1)};
        if (!ranges.empty() && ranges.back().last == next.first)
            ranges.back().last = next.last;
        else
            ranges.push_back(next);
    };
    std::size_t index = 0;
    model_.for_each_group([&](const auto& group) {
        cleared_.emplace_back();
        schedules_[index++].for_each_colour([&](const std::vector<ElementRun>& runs) {
            for (const ElementRun& run : runs) {
                std::vector<int> fresh;
                ElementSchedule::visit_nodes(group.connections, run, [&](std::size_t node) {
                    if (seen[node] == 0) fresh.push_back(static_cast<int>(node));
                    seen[node] = 1;
                });
                std::sort(fresh.begin(), fresh.end());
                cleared_.back().emplace_back();
                for (const int node : fresh) append(node, cleared_.back().back());
            }
        });
    });
    const int blocks = static_cast<int>(numbering_.block_sizes().size());
    for (int block = 0; block < blocks; ++block)
        if (block >= nodes || seen[static_cast<std::size_t>(block)] == 0)
            append(block, cleared_first_);
}

template <class Scene>
void Assembly<Scene>::clear_values(const std::vector<ValueRange>& ranges) {
    for (const ValueRange& range : ranges)
        std::fill(tangent_.valuePtr() + range.first, tangent_.valuePtr() + range.last, 0.0);
}

template <class Scene>
template <class Element>
void Assembly<Scene>::element_coordinates(const Slots& slots, int (&out)[Element::dofs]) const {
    const Layout& layout = model_.layout();
    if (slots.plain) {
        constexpr int half = Element::dofs / 2;
        for (int a = 0; a < 2; ++a)
            for (int i = 0; i < half; ++i)
                out[a * half + i] = layout.first(slots.node[static_cast<std::size_t>(a)]) + i;
        return;
    }
    int at = 0;
    for (const int node : slots.node)
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            if (!Element::fields.contains(field)) continue;
            const int first = layout.index({{node}, field});
            for (int i = 0; i < Scene::dimension; ++i) out[at++] = first + i;
        }
}

template <class Scene>
void Assembly<Scene>::build_gravity() {
    gravity_.setZero(numbering_.coordinates());
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        std::vector<Vector<double, Element::dofs>> forces;
        for (const Element& prototype : group.prototypes)
            forces.push_back(prototype.gravity(model_.gravity()));
        int coordinate[Element::dofs];
        for (std::size_t k = 0; k < slots.size(); ++k) {
            element_coordinates<Element>(slots[k], coordinate);
            const auto prototype = static_cast<std::size_t>(group.connections[k].prototype);
            for (int i = 0; i < Element::dofs; ++i) gravity_[coordinate[i]] += forces[prototype][i];
        }
    });
    for (const PointMass& point : model_.masses())
        gravity_.template segment<Scene::dimension>(model_.coordinate(point.node, Field::r)) +=
            point.mass * model_.gravity();
}

template <class Scene>
std::optional<Fault> Assembly<Scene>::evaluate(const Configuration& at, Request request,
                                               const VectorX* increment, const Correction* last) {
    detail::require(at.q.size() == numbering_.coordinates() && at.v.size() == at.q.size() &&
                        at.multipliers.size() == numbering_.multipliers(),
                    "Assembly::evaluate: expected ", numbering_.coordinates(),
                    " coordinates and rates and ", numbering_.multipliers(), " multipliers, got ",
                    at.q.size(), ", ", at.v.size(), " and ", at.multipliers.size());
    internal_.setZero(numbering_.coordinates());
    constraint_.setZero(numbering_.coordinates());
    strain_energy_ = 0.0;
    if (request != Request::force) clear_values(cleared_first_);
    if (request == Request::tangent_and_damping) {
        if (damping_.nonZeros() != tangent_.nonZeros()) damping_ = pattern_.matrix();
        std::fill_n(damping_.valuePtr(), damping_.nonZeros(), 0.0);
    }
    std::size_t index = 0;
    model_.for_each_group([&](const auto& group) {
        strain_energy_ += add_elements(group, index++, at, request, increment, last);
    });
    const double gravity_scale = model_.gravity_scale(at.instant);
    external_ = gravity_scale * gravity_;
    load_potential_ = -external_.dot(at.q);
    add_loads(at, request);
    add_constraints(at, request);
    if (std::isfinite(strain_energy_) && internal_.allFinite() && external_.allFinite() &&
        constraint_.allFinite())
        return std::nullopt;
    return inspect(at.q).value_or(Fault{Status::not_finite, -1, -1});
}

template <class Scene>
template <class Element>
double Assembly<Scene>::add_elements(const ElementGroup<Element>& group, std::size_t index,
                                     const Configuration& at, Request request,
                                     const VectorX* increment, const Correction* last) {
    const std::vector<Slots>& slots = slots_[index];
    return schedules_[index].sum([&](const ElementRun& run, std::size_t place) {
        if (request != Request::force) clear_values(cleared_[index][place]);
        double energy = 0.0;
        int k = run.first;
        constexpr int lanes = detail::pack_lanes<Element>;
        if constexpr (lanes > 1) {
            const auto prototype = [&](int element) {
                return group.connections[static_cast<std::size_t>(element)].prototype;
            };
            const bool plain = increment == nullptr && last == nullptr;
            for (; plain && k + lanes <= run.last; k += lanes) {
                bool equal = true;
                for (int lane = 1; lane < lanes; ++lane)
                    equal = equal && prototype(k + lane) == prototype(k);
                if (!equal) break;
                energy += add_pack<lanes>(group.element(k), &slots[static_cast<std::size_t>(k)], at,
                                          request);
            }
        }
        for (; k < run.last; ++k)
            energy += add_element(group.element(k), slots[static_cast<std::size_t>(k)], at, request,
                                  increment, last);
        return energy;
    });
}

template <class Scene>
template <class Element>
double Assembly<Scene>::add_element(const Element& element, const Slots& slots,
                                    const Configuration& at, Request request,
                                    const VectorX* increment, const Correction* last) {
    int coordinate[Element::dofs];
    element_coordinates<Element>(slots, coordinate);
    const auto gathered = [&](const VectorX& all) {
        typename Element::Coordinates own;
        for (int i = 0; i < Element::dofs; ++i) own[i] = all[coordinate[i]];
        return own;
    };
    const typename Element::Coordinates e = gathered(at.q);
    if (request == Request::force && increment == nullptr) {
        const typename Element::Coordinates force = element.force(e);
        for (int i = 0; i < Element::dofs; ++i) internal_[coordinate[i]] += force[i];
        return element.energy(e);
    }
    auto result = [&] {
        if constexpr (detail::EvaluatesMixed<Element>::value)
            if (last != nullptr)
                return element.evaluate(e, gathered(last->before), gathered(last->change));
        return element.evaluate(e);
    }();
    if (increment != nullptr) result.force.noalias() += result.tangent * gathered(*increment);
    for (int i = 0; i < Element::dofs; ++i) internal_[coordinate[i]] += result.force[i];
    if (request != Request::force) scatter<Element>(slots, result.tangent, tangent_.valuePtr());
    return result.energy;
}

template <class Scene>
template <int Lanes, class Element>
double Assembly<Scene>::add_pack(const Element& element, const Slots* slots,
                                 const Configuration& at, Request request) {
    int coordinate[Lanes][Element::dofs];
    Vector<Pack<Lanes>, Element::dofs> e;
    for (int lane = 0; lane < Lanes; ++lane) {
        element_coordinates<Element>(slots[lane], coordinate[lane]);
        for (int i = 0; i < Element::dofs; ++i) e[i].set(lane, at.q[coordinate[lane][i]]);
    }
    const auto add_force = [&](const auto& force) {
        for (int lane = 0; lane < Lanes; ++lane)
            for (int i = 0; i < Element::dofs; ++i)
                internal_[coordinate[lane][i]] += force[i][lane];
    };
    if (request == Request::force) {
        add_force(element.force(e));
        return lane_sum(element.energy(e));
    }
    const auto result = element.evaluate(e);
    add_force(result.force);
    Matrix<double, Element::dofs> tangent;
    for (int lane = 0; lane < Lanes; ++lane) {
        for (int k = 0; k < tangent.size(); ++k) tangent(k) = result.tangent(k)[lane];
        scatter<Element>(slots[lane], tangent, tangent_.valuePtr());
    }
    return lane_sum(result.energy);
}

template <class Scene>
template <class Element, class Block>
void Assembly<Scene>::scatter(const Slots& slots, const Block& block, double* values) const {
    constexpr int half = Element::dofs / 2;
    if (slots.plain) {
        for (int b = 0; b < 2; ++b)
            for (int j = 0; j < half; ++j) {
                const int offset = pattern_.column_offset(slots.node[b], j);
                for (int a = 0; a < 2; ++a) {
                    if (slots.base[a][b] < 0) continue;
                    double* column = values + slots.base[a][b] + offset;
                    const int from = a == b && pattern_.storage() == Storage::lower ? j : 0;
                    for (int i = from; i < half; ++i)
                        column[i] += block(a * half + i, b * half + j);
                }
            }
        return;
    }
    int row_of[Element::dofs];  // row within the node's block, -1 where held
    element_coordinates<Element>(slots, row_of);
    for (int i = 0; i < Element::dofs; ++i) {
        const int equation = numbering_.equation(row_of[i]);
        row_of[i] = equation < 0 ? -1 : equation - pattern_.first(slots.node[i >= half]);
    }
    for (int b = 0; b < 2; ++b)
        for (int j = b * half; j < (b + 1) * half; ++j) {
            if (row_of[j] < 0) continue;
            const int offset = pattern_.column_offset(slots.node[b], row_of[j]);
            for (int a = 0; a < 2; ++a) {
                if (slots.base[a][b] < 0) continue;
                double* column = values + slots.base[a][b] + offset;
                const int above = a == b && pattern_.storage() == Storage::lower ? row_of[j] : 0;
                for (int i = a * half; i < (a + 1) * half; ++i)
                    if (row_of[i] >= above) column[row_of[i]] += block(i, j);
            }
        }
}

template <class Scene>
void Assembly<Scene>::add_value(int row, int column, double value, SparseMatrix& matrix) const {
    const int i = numbering_.equation(row);
    const int j = numbering_.equation(column);
    if (i < 0 || j < 0 || (pattern_.storage() == Storage::lower && i < j)) return;
    const int a = numbering_.block(row);
    const int b = numbering_.block(column);
    const int slot = pattern_.base(a, b) + pattern_.column_offset(b, j - pattern_.first(b)) + i -
                     pattern_.first(a);
    matrix.valuePtr()[slot] += value;
}

template <class Scene>
template <class Visitor>
void Assembly<Scene>::for_each_load(const VectorX& q, const VectorX& v, double time,
                                    bool derivatives, Visitor&& visit) const {
    LoadState local;
    LoadResult result;
    local.time = time;
    local.derivatives = derivatives;
    for (std::size_t k = 0; k < load_coordinates_.size(); ++k) {
        const std::vector<int>& coordinates = load_coordinates_[k];
        const auto size = static_cast<Eigen::Index>(coordinates.size());
        local.q = q(coordinates);
        local.v = v(coordinates);
        const AnyLoad& load = model_.loads()[k].load;
        const Eigen::Index rows = load.constant() ? 0 : size;
        result.force.setZero(size);
        result.stiffness.setZero(rows, rows);
        result.damping.setZero(rows, rows);
        result.potential = 0.0;
        load.evaluate(local, result);
        const auto sized = [&](const MatrixX& m) { return m.rows() == rows && m.cols() == rows; };
        detail::require(
            result.force.size() == size && sized(result.stiffness) && sized(result.damping),
            "a load on ", size, " coordinates changed the size of its results; its force has ",
            result.force.size(), " entries");
        visit(model_.loads()[k], coordinates, result);
    }
}

template <class Scene>
void Assembly<Scene>::add_loads(const Configuration& at, Request request) {
    for_each_load(
        at.q, at.v, at.instant.time, request != Request::force,
        [&](const ScaledLoad& load, const std::vector<int>& coordinates, const LoadResult& result) {
            const double scale = load.scale(at.instant);
            const int size = static_cast<int>(coordinates.size());
            load_potential_ += scale * result.potential;
            for (int i = 0; i < size; ++i)
                external_[coordinates[static_cast<std::size_t>(i)]] += scale * result.force[i];
            if (request == Request::force || result.stiffness.size() == 0) return;
            for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j) {
                    const int row = coordinates[static_cast<std::size_t>(i)];
                    const int column = coordinates[static_cast<std::size_t>(j)];
                    if (result.stiffness(i, j) != 0.0)
                        add_value(row, column, -scale * result.stiffness(i, j), tangent_);
                    if (request == Request::tangent_and_damping && result.damping(i, j) != 0.0)
                        add_value(row, column, -scale * result.damping(i, j), damping_);
                }
        });
}

template <class Scene>
VectorX Assembly<Scene>::load_rate(const VectorX& q, double factor) const {
    constexpr double step = 1e-4;  // exact for loads in proportion to the factor
    const auto slope = [&](const auto& scale) {
        return (scale(Instant{factor + step, factor + step}) -
                scale(Instant{factor - step, factor - step})) /
               (2.0 * step);
    };
    VectorX rate = slope([&](const Instant& at) { return model_.gravity_scale(at); }) * gravity_;
    for_each_load(
        q, VectorX::Zero(q.size()), factor, false,
        [&](const ScaledLoad& load, const std::vector<int>& coordinates, const LoadResult& result) {
            const double scale = slope([&](const Instant& at) { return load.scale(at); });
            for (std::size_t i = 0; i < coordinates.size(); ++i)
                rate[coordinates[i]] += scale * result.force[static_cast<Eigen::Index>(i)];
        });
    return rate;
}

template <class Scene>
void Assembly<Scene>::add_constraints(const Configuration& at, Request request) {
    violation_.setZero(numbering_.multipliers());
    violation_rate_.setZero(numbering_.multipliers());
    convection_.setZero(numbering_.multipliers());
    ConstraintState local;
    ConstraintResult result;
    local.time = at.instant.time;
    int first = 0;
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        const AnyConstraint& constraint = model_.constraints()[k];
        const std::vector<int>& coordinates = constraint_coordinates_[k];
        const auto size = static_cast<Eigen::Index>(coordinates.size());
        const int equations = constraint.equations();
        local.q = at.q(coordinates);
        local.v = at.v(coordinates);
        local.multipliers = at.multipliers.segment(first, equations);
        result.violation.setZero(equations);
        result.jacobian.setZero(equations, size);
        result.stiffness.setZero(size, size);
        result.rate.setZero(equations);
        result.convection.setZero(equations);
        constraint.evaluate(local, result);
        detail::require(result.violation.size() == equations &&
                            result.jacobian.rows() == equations && result.jacobian.cols() == size &&
                            result.stiffness.rows() == size && result.stiffness.cols() == size &&
                            result.rate.size() == equations &&
                            result.convection.size() == equations,
                        "constraint ", constraint.name(), " of ", equations, " equations on ", size,
                        " coordinates changed the size of its results");
        violation_.segment(first, equations) = result.violation;
        violation_rate_.segment(first, equations) = result.rate;
        convection_.segment(first, equations) = result.convection;
        for (Eigen::Index i = 0; i < size; ++i)
            constraint_[coordinates[static_cast<std::size_t>(i)]] +=
                result.jacobian.col(i).dot(local.multipliers);
        if (request != Request::force) add_constraint_blocks(static_cast<int>(k), result);
        first += equations;
    }
}

template <class Scene>
void Assembly<Scene>::add_constraint_blocks(int constraint, const ConstraintResult& result) {
    const std::vector<int>& coordinates =
        constraint_coordinates_[static_cast<std::size_t>(constraint)];
    const int own = numbering_.constraint_block(constraint);
    const int size = static_cast<int>(coordinates.size());
    double* values = tangent_.valuePtr();
    for (int j = 0; j < size; ++j) {
        const int coordinate = coordinates[static_cast<std::size_t>(j)];
        const int equation = numbering_.equation(coordinate);
        if (equation < 0) continue;
        const int node = numbering_.block(coordinate);
        const int place = equation - pattern_.first(node);
        for (int i = 0; i < size; ++i)
            if (result.stiffness(i, j) != 0.0)
                add_value(coordinates[static_cast<std::size_t>(i)], coordinate,
                          result.stiffness(i, j), tangent_);
        for (int i = 0; i < result.jacobian.rows(); ++i) {
            const double value = result.jacobian(i, j);
            values[pattern_.base(own, node) + pattern_.column_offset(node, place) + i] += value;
            values[pattern_.base(node, own) + pattern_.column_offset(own, i) + place] += value;
        }
    }
}

template <class Scene>
std::optional<Fault> Assembly<Scene>::inspect(const VectorX& q) const {
    int group_index = 0;
    std::optional<Fault> fault;
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        int coordinate[Element::dofs];
        typename Element::Coordinates e;
        for (std::size_t k = 0; k < slots.size() && !fault; ++k) {
            element_coordinates<Element>(slots[k], coordinate);
            for (int i = 0; i < Element::dofs; ++i) e[i] = q[coordinate[i]];
            const int index = static_cast<int>(k);
            if (!e.allFinite())
                fault = Fault{Status::not_finite, group_index, index};
            else if (!group.element(index).admissible(e))
                fault = Fault{Status::degenerate, group_index, index};
        }
        ++group_index;
    });
    return fault;
}

template <class Scene>
void Assembly<Scene>::residual(VectorX& out) const {
    out.resize(numbering_.unknowns());
    for (int k = 0; k < numbering_.coordinates(); ++k)
        if (const int equation = numbering_.equation(k); equation >= 0)
            out[equation] = internal_[k] + constraint_[k] - external_[k];
    out.tail(numbering_.multipliers()) = violation_;
}

template <class Scene>
SparseMatrix Assembly<Scene>::mass() const {
    SparseMatrix result = pattern_.matrix();
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        std::vector<Matrix<double, Element::dofs>> masses;
        for (const Element& prototype : group.prototypes) masses.push_back(prototype.mass());
        for (std::size_t k = 0; k < slots.size(); ++k)
            scatter<Element>(slots[k],
                             masses[static_cast<std::size_t>(group.connections[k].prototype)],
                             result.valuePtr());
    });
    for (const PointMass& point : model_.masses())
        for (int i = 0; i < Scene::dimension; ++i) {
            const int at = model_.coordinate(point.node, Field::r) + i;
            add_value(at, at, point.mass, result);
        }
    return result;
}

template <class Scene>
VectorX Assembly<Scene>::mass_product(const VectorX& a) const {
    detail::require(a.size() == numbering_.coordinates(), "Assembly::mass_product: expected ",
                    numbering_.coordinates(), " coordinates, got ", a.size());
    VectorX result = VectorX::Zero(a.size());
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        std::vector<Matrix<double, Element::dofs>> masses;
        for (const Element& prototype : group.prototypes) masses.push_back(prototype.mass());
        int coordinate[Element::dofs];
        typename Element::Coordinates e;
        for (std::size_t k = 0; k < slots.size(); ++k) {
            element_coordinates<Element>(slots[k], coordinate);
            for (int i = 0; i < Element::dofs; ++i) e[i] = a[coordinate[i]];
            const typename Element::Coordinates product =
                masses[static_cast<std::size_t>(group.connections[k].prototype)] * e;
            for (int i = 0; i < Element::dofs; ++i) result[coordinate[i]] += product[i];
        }
    });
    for (const PointMass& point : model_.masses()) {
        const int at = model_.coordinate(point.node, Field::r);
        result.template segment<Scene::dimension>(at) +=
            point.mass * a.template segment<Scene::dimension>(at);
    }
    return result;
}

template <class Scene>
void Assembly<Scene>::apply_supports(const Instant& instant, VectorX& q) const {
    detail::require(q.size() == numbering_.coordinates(), "the state has ", q.size(),
                    " coordinates, the model has ", numbering_.coordinates());
    for (const Support& support : model_.supports())
        if (support.value)
            q[model_.layout().index({support.node, support.field}) + support.component] =
                support.value(instant.time);
}

}  // namespace ancf
