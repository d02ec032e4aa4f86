// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/list.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Returns the worst fault that a call gives in the parts of a scene; of another part its status.
template <class Call>
[[nodiscard]] std::optional<Fault> worst_of_parts(const Exchange& exchange, const Call& call) {
    std::optional<Fault> own;
    const auto status = [&] {
        own = call();
        return own ? static_cast<double>(own->status) : 0.0;
    };
    const auto worst = static_cast<Status>(static_cast<int>(largest_of(exchange, status)));
    if (worst == (own ? own->status : Status::converged)) return own;
    return Fault{worst, -2, -1};
}

/// Throws where the mass of an element is not finite or symmetric, or has a negative diagonal.
ANCF_INLINE void require_mass(const ElementGroup& group, const double* mass) {
    constexpr double round_off = 1e-10;
    const int dofs = group.dofs();
    bool good = true;
    for (int i = 0; i < dofs; ++i)
        for (int j = 0; j <= i; ++j) {
            const double lower = mass[i + j * dofs], upper = mass[j + i * dofs];
            const double size = std::sqrt(mass[i + i * dofs]) * std::sqrt(mass[j + j * dofs]);
            good = good && std::isfinite(lower) && std::abs(lower - upper) <= round_off * size;
        }
    require(good, "the mass of an element of the type ", group.name(),
            " is not symmetric or not positive definite");
}

/// Returns the mass matrices of all prototypes of a group, by columns, one after the other.
[[nodiscard]] ANCF_INLINE List<double> prototype_masses(const ElementGroup& group) {
    const std::ptrdiff_t size = group.dofs() * group.dofs();
    List<double> masses(static_cast<std::size_t>(size * group.prototype_count()));
    for (int k = 0; k < group.prototype_count(); ++k) {
        double* const mass = masses.data() + size * k;
        group.mass(k, mass);
        require_mass(group, mass);
    }
    return masses;
}

/// Returns the derivative of a factor by the load factor: central, or by the values above (side 1)
/// or below (side -1) alone.
/// @param scale  as scale(Instant)
template <class Scale>
[[nodiscard]] double slope_of(const Scale& scale, double factor, double side) {
    const double step = factor_step(factor) * (side == 0.0 ? 1.0 : side);
    const auto at = [&](double steps) {
        return scale(Instant{factor + steps * step, factor + steps * step});
    };
    const double change =
        side == 0.0 ? at(1.0) - at(-1.0) : 4.0 * at(1.0) - at(2.0) - 3.0 * at(0.0);
    return change / (2.0 * step);
}

}  // namespace detail

ANCF_INLINE Assembly::Assembly(const Scene& model, Storage storage)
    : model_(model), numbering_(model), revision_(model.revision()) {
    list_coordinates();
    if (storage == Storage::lower) {
        detail::require(
            model.constraints().empty(),
            "Assembly: constraints make the tangent indefinite; choose a solver of full "
            "storage such as EigenLu, Klu or Umfpack");
        detail::require(
            model.has_symmetric_loads(),
            "Assembly: a load has an unsymmetric stiffness; choose a solver of full storage "
            "such as EigenLu, Klu or Umfpack, or let a load of your own declare "
            "`constant_force` or `symmetric_stiffness` where that is so");
    }
    list_followed();
    build_pattern(storage);
    plans_ = List<GroupPlan>(model.groups().size());
    for (std::size_t group = 0; group < plans_.size(); ++group) build_slots(group);
    build_clearing();
    build_gravity();
    SparseMatrix zero = pattern_.matrix();
    tangent_.swap(zero);
    check_arms();
}

ANCF_INLINE void Assembly::refresh() {
    const Revision now = model_.revision();
    if (now == revision_) return;
    check_scene();
    build_gravity();
    revision_ = now;
}

ANCF_INLINE void Assembly::check_scene() const {
    detail::require(model_.revision().scene == revision_.scene,
                    "nodes, elements, supports, loads or constraints of the model have changed: "
                    "make a new Assembly or DynamicProblem for it");
}

ANCF_INLINE void Assembly::list_coordinates() {
    const Layout& layout = model_.layout();
    const Dependence& dependence = model_.dependence();
    for (const ScaledLoad& load : model_.loads())
        load_coordinates_.emplace_back(layout, dependence, load.load.coupling(), "load");
    for (const AnyConstraint& constraint : model_.constraints()) {
        constraint_coordinates_.emplace_back(layout, dependence, constraint.coupling(),
                                             "constraint");
        List<int>& powers = constraint_powers_.emplace_back();
        for (const int coordinate : constraint_coordinates_.back().acted())
            powers.push_back(length_power(layout.field_of(coordinate)));
    }
}

ANCF_INLINE void Assembly::list_followed() {
    const Layout& layout = model_.layout();
    if (model_.attachments().empty()) return;
    followed_.resize(static_cast<std::size_t>(layout.nodes()));
    for (const AttachedVector& attachment : model_.attachments()) {
        List<int>& of = followed_[attachment.vector.node.index];
        for (const Dependence::Part& part :
             model_.dependence().parts(layout.index(attachment.vector)))
            if (const int node = layout.node_of(part.first);
                std::find(of.begin(), of.end(), node) == of.end())
                of.push_back(node);
    }
}

ANCF_INLINE void Assembly::check_arms() const {
    const detail::Exchange* const exchange = model_.exchange();
    if (exchange == nullptr && model_.attachments().empty()) return;
    const Layout& layout = model_.layout();
    const Dependence& dependence = model_.dependence();
    VectorX held = VectorX::Zero(layout.size());  // 0 where nothing holds
    const auto hold = [&](const NodeField& at, bool arms) {
        if (at.field == Field::r && !arms) return;
        const int first = layout.index(at);
        held[first] = 1.0;
        if (!dependence.attached(first)) return;
        for (const Dependence::Part& part : dependence.parts(first)) held[part.first] = 1.0;
    };
    // What holds one position holds no arm's length; what holds two against each other may.
    const auto hold_all = [&](const Coupling& coupling) {
        int positions = 0;
        for (const NodeField& at : coupling) positions += at.field == Field::r ? 1 : 0;
        for (const NodeField& at : coupling) hold(at, positions > 1);
    };
    for (const auto& group : model_.groups())
        for (const Connection& connection : group->connections)
            for (int k = 0; k < group->fields().count(); ++k) {
                hold({connection.first, group->fields().at(k)}, false);
                hold({connection.second, group->fields().at(k)}, false);
            }
    for (const Support& support : model_.supports()) hold({support.node, support.field}, false);
    for (const AnyConstraint& constraint : model_.constraints()) hold_all(constraint.coupling());
    for (const ScaledLoad& load : model_.loads())
        if (!load.load.constant()) hold_all(load.load.coupling());
    if (exchange != nullptr) exchange->add(held);
    detail::together(exchange, [&] {
        for (const AttachedVector& attachment : model_.attachments()) {
            if (attachment.vector.field != Field::r) continue;
            for (const Dependence::Part& part : dependence.parts(layout.index(attachment.vector))) {
                const Field field = layout.field_of(part.first);
                detail::require(field == Field::r || held[part.first] != 0, "Model::attach: node ",
                                attachment.vector.node.index, " stands beside node ",
                                layout.node_of(part.first), " along ", to_string(field),
                                ", which no element there has, so nothing holds it: put a stiff "
                                "CrossSectionBeam between them");
            }
        }
    });
}

ANCF_INLINE void Assembly::build_pattern(Storage storage) {
    List<BlockPair> pairs;
    List<int> blocks;
    const auto couple_blocks = [&] {
        std::sort(blocks.data(), blocks.data() + blocks.size());
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        for (std::size_t a = 0; a < blocks.size(); ++a)
            for (std::size_t b = a + 1; b < blocks.size(); ++b)
                pairs.push_back({blocks[a], blocks[b]});
    };
    const auto couple_all = [&](const List<int>& coordinates) {
        blocks.clear();
        for (const int k : coordinates) blocks.push_back(numbering_.block(k));
        couple_blocks();
    };
    for (const auto& group : model_.groups())
        for (const Connection& c : group->connections) {
            pairs.push_back({c.first.index, c.second.index});
            if (followed_.empty()) continue;
            blocks.clear();
            for (const NodeId node : {c.first, c.second}) {
                const auto& others = followed_[node.index];
                blocks.push_back(node.index);
                for (const int other : others) blocks.push_back(other);
            }
            if (blocks.size() > 2) couple_blocks();
        }
    for (std::size_t k = 0; k < load_coordinates_.size(); ++k)
        if (!model_.loads()[k].load.constant()) couple_all(load_coordinates_[k].acted());
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        for (const Coupling& part : model_.constraints()[k].stiffness_parts())
            couple_all(
                detail::LocalCoordinates(model_.layout(), model_.dependence(), part, "constraint")
                    .acted());
        for (const int coordinate : constraint_coordinates_[k].acted())
            pairs.push_back(
                {numbering_.block(coordinate), numbering_.constraint_block(static_cast<int>(k))});
    }
    pattern_ = BlockPattern(numbering_.block_sizes(), pairs, storage);
}

ANCF_INLINE void Assembly::build_slots(std::size_t index) {
    const Layout& layout = model_.layout();
    const ElementGroup& group = *model_.groups()[index];
    const int half = group.dofs() / 2;
    GroupPlan& plan = plans_[index];
    plan.slots.reserve(group.connections.size());
    for (const Connection& c : group.connections) {
        ElementSlots slots;
        slots.node = {c.first.index, c.second.index};
        slots.plain = true;
        slots.attached = -1;
        for (const int node : slots.node)
            if (!followed_.empty() && !followed_[node].empty())
                slots.attached = static_cast<int>(plan.attached.size());
        if (slots.attached >= 0) {
            detail::AttachedElement& element =
                plan.attached.emplace_back(layout, model_.dependence(), group.fields(), slots.node);
            for (const int row : element.blocks)
                for (const int column : element.blocks)
                    element.base.push_back(pattern_.stored(row, column) ? pattern_.base(row, column)
                                                                        : -1);
        }
        for (std::size_t a = 0; a < 2; ++a) {
            const int node = slots.node[a];
            const int size = pattern_.first(node + 1) - pattern_.first(node);
            slots.plain = slots.plain && layout.fields(node) == group.fields() && size == half;
            for (std::size_t b = 0; b < 2; ++b)
                slots.base[a][b] =
                    pattern_.stored(node, slots.node[b]) ? pattern_.base(node, slots.node[b]) : -1;
        }
        plan.slots.push_back(slots);
    }
    plan.schedule = ElementSchedule(group.connections, layout.nodes(), followed_);
}

// Each run clears the columns of the nodes that no run before it touched, just before it adds to
// them: they come from memory once, and threads share that work too.
ANCF_INLINE void Assembly::build_clearing() {
    const int nodes = model_.layout().nodes();
    List<char> seen(static_cast<std::size_t>(nodes), 0);
    const auto append = [&](int block, std::size_t first, ValueRanges& ranges) {
        const ValueRange next{pattern_.first_value(block), pattern_.first_value(block + 1)};
        if (ranges.size() > first && ranges.back().last == next.first)
            ranges.back().last = next.last;
        else
            ranges.push_back(next);
    };
    List<int> fresh;
    for (std::size_t index = 0; index < plans_.size(); ++index) {
        GroupPlan& plan = plans_[index];
        for (const ElementRun& run : plan.schedule.runs()) {
            fresh.clear();
            ElementSchedule::visit_nodes(model_.groups()[index]->connections, run, followed_,
                                         [&](std::size_t node) {
                                             if (seen[node] == 0)
                                                 fresh.push_back(static_cast<int>(node));
                                             seen[node] = 1;
                                         });
            std::sort(fresh.data(), fresh.data() + fresh.size());
            const std::size_t first = plan.cleared.size();
            plan.first_cleared.push_back(first);
            for (const int node : fresh) append(node, first, plan.cleared);
        }
        plan.first_cleared.push_back(plan.cleared.size());
    }
    const int blocks = static_cast<int>(numbering_.block_sizes().size());
    for (int block = 0; block < blocks; ++block)
        if (block >= nodes || seen[block] == 0) append(block, 0, cleared_first_);
}

ANCF_INLINE void Assembly::element_coordinates(const ElementPlace& place, int* out) const {
    const auto group = static_cast<std::size_t>(place.group);
    detail::element_coordinates(model_.layout(), model_.dimension(),
                                model_.groups()[group]->fields(),
                                plans_[group].slots[place.element], out);
}

ANCF_INLINE void Assembly::gather_element(const ElementPlace& place, const VectorX& q,
                                          double* e) const {
    int indices[ElementGroup::max_dofs];
    element_coordinates(place, indices);
    const int dofs = model_.groups()[place.group]->dofs();
    for (int i = 0; i < dofs; ++i) e[i] = q[indices[i]];
}

template <class Visitor>
void Assembly::for_each_element(std::size_t group, const Visitor& visit) const {
    int indices[ElementGroup::max_dofs];
    const int count = static_cast<int>(plans_[group].slots.size());
    for (int element = 0; element < count; ++element) {
        const ElementPlace place{static_cast<int>(group), element};
        element_coordinates(place, indices);
        visit(place, indices);
    }
}

ANCF_INLINE void Assembly::build_gravity() {
    gravity_.setZero(numbering_.coordinates());
    double acceleration[3] = {};
    for (int k = 0; k < model_.dimension(); ++k) acceleration[k] = model_.gravity_component(k);
    List<double> forces;  // of a group's prototypes
    for (std::size_t g = 0; g < plans_.size(); ++g) {
        const ElementGroup& group = *model_.groups()[g];
        const std::ptrdiff_t dofs = group.dofs();
        forces.resize(static_cast<std::size_t>(dofs * group.prototype_count()));
        for (int k = 0; k < group.prototype_count(); ++k)
            group.gravity(k, acceleration, forces.data() + dofs * k);
        for_each_element(g, [&](const ElementPlace& at, const int* indices) {
            const double* const force = forces.data() + dofs * group.prototype_of(at.element);
            for (int i = 0; i < group.dofs(); ++i) gravity_[indices[i]] += force[i];
        });
    }
    for (const PointMass& point : model_.masses()) {
        const int at = model_.coordinate(point.node, Field::r);
        for (int i = 0; i < model_.dimension(); ++i)
            gravity_[at + i] += point.mass * acceleration[i];
    }
    numbering_.dependence().carry(gravity_);
}

ANCF_INLINE std::optional<Fault> Assembly::evaluate(const Configuration& at, Request request,
                                                    const VectorX* increment,
                                                    const Correction* last) {
    const auto own = [&] { return evaluate_own(at, request, increment, last); };
    const detail::Exchange* const exchange = model_.exchange();
    if (exchange == nullptr) return own();
    if (const auto fault = detail::worst_of_parts(*exchange, own)) return fault;
    exchange->add(internal_);
    exchange->add(external_);
    if (!exchange->constraints().empty()) exchange->add(constraint_);
    double energies[2] = {strain_energy_, load_potential_};
    exchange->sum(energies, 2);
    strain_energy_ = energies[0];
    load_potential_ = energies[1];
    return std::nullopt;
}

ANCF_INLINE std::optional<Fault> Assembly::evaluate_own(const Configuration& at, Request request,
                                                        const VectorX* increment,
                                                        const Correction* last) {
    refresh();
    detail::require(at.q.size() == numbering_.coordinates() && at.v.size() == at.q.size() &&
                        at.multipliers.size() == numbering_.multipliers(),
                    "Assembly::evaluate: expected ", numbering_.coordinates(),
                    " coordinates and rates and ", numbering_.multipliers(), " multipliers, got ",
                    at.q.size(), ", ", at.v.size(), " and ", at.multipliers.size());
    if (increment) check_size("evaluate", "increments", *increment);
    if (last) {
        check_size("evaluate", "coordinates before the correction", last->before);
        check_size("evaluate", "corrections", last->change);
    }
    energy_known_ = request != Request::force || increment != nullptr;
    if (!energy_known_) force_q_ = at.q;
    internal_.setZero(numbering_.coordinates());
    constraint_.setZero(numbering_.coordinates());
    strain_energy_ = 0.0;
    if (request != Request::force) clear_values(cleared_first_.begin(), cleared_first_.end());
    if (request == Request::tangent_and_damping) {
        if (detail::entries(damping_) != detail::entries(tangent_)) {
            SparseMatrix zero = pattern_.matrix();
            damping_.swap(zero);
        }
        std::fill_n(damping_.valuePtr(), detail::entries(damping_), 0.0);
    }
    const bool predicts = last != nullptr || increment != nullptr;
    predicted_.setZero(predicts ? numbering_.coordinates() : 0);
    add_elements(at, request, increment, last);
    numbering_.dependence().carry(internal_);
    if (predicted_.size() > 0) numbering_.dependence().carry(predicted_);
    const double gravity_scale = model_.gravity_scale(at.instant);
    external_ = gravity_;
    for (double& entry : external_) entry *= gravity_scale;
    load_potential_ = -external_.dot(at.q);
    add_loads(at, request);
    add_constraints(at, request);
    const bool elements = std::isfinite(strain_energy_) && detail::all_finite(internal_);
    if (elements && faulty_load_ < 0 && faulty_constraint_ < 0 && detail::all_finite(external_) &&
        detail::all_finite(constraint_))
        return std::nullopt;
    std::optional<Fault> found = inspect(at.q);
    if (!found && !elements) found = inspect_values(at.q);
    Fault fault = found.value_or(Fault{Status::not_finite, -1, -1});
    if (increment != nullptr && fault.support < 0) fault.support = faulty_support(*increment);
    return fault;
}

ANCF_INLINE double Assembly::strain_energy() const {
    if (energy_known_) return strain_energy_;
    check_scene();
    strain_energy_ = 0.0;
    for (std::size_t index = 0; index < plans_.size(); ++index) {
        const ElementGroup& group = *model_.groups()[index];
        strain_energy_ += plans_[index].schedule.sum([&](const ElementRun& run, std::size_t) {
            double energy = 0.0;
            for (int k = run.first; k < run.last; ++k) {
                double e[ElementGroup::max_dofs];
                gather_element({static_cast<int>(index), k}, force_q_, e);
                energy += group.energy(group.prototype_of(k), e);
            }
            return energy;
        });
    }
    if (model_.exchange() != nullptr) model_.exchange()->sum(&strain_energy_, 1);
    energy_known_ = true;
    return strain_energy_;
}

ANCF_INLINE GroupTarget Assembly::target(std::size_t group, double* values) const {
    const GroupPlan& plan = plans_[group];
    return {plan.slots.data(),
            model_.layout(),
            numbering_.equations(),
            pattern_.first_rows(),
            pattern_.heights(),
            pattern_.storage(),
            values,
            plan.attached.empty() ? nullptr : plan.attached.data()};
}

ANCF_INLINE void Assembly::add_elements(const Configuration& at, Request request,
                                        const VectorX* increment, const Correction* last) {
    const bool tangent = request != Request::force;
    for (std::size_t index = 0; index < plans_.size(); ++index) {
        const ElementGroup& group = *model_.groups()[index];
        const GroupPlan& plan = plans_[index];
        GroupTarget target = this->target(index, tangent_.valuePtr());
        target.q = at.q.data();
        target.increment = increment != nullptr ? increment->data() : nullptr;
        target.before = last != nullptr ? last->before.data() : nullptr;
        target.change = last != nullptr ? last->change.data() : nullptr;
        target.tangent = tangent;
        target.internal_force = internal_.data();
        if (predicted_.size() > 0) target.predicted_force = predicted_.data();
        strain_energy_ += plans_[index].schedule.sum([&](const ElementRun& run, std::size_t place) {
            if (tangent)
                clear_values(plan.cleared.begin() + plan.first_cleared[place],
                             plan.cleared.begin() + plan.first_cleared[place + 1]);
            return group.add(run, target);
        });
    }
}

ANCF_INLINE void Assembly::add_matrix(const List<int>& coordinates, double scale,
                                      const MatrixX& local, SparseMatrix& matrix) const {
    const auto size = static_cast<Eigen::Index>(coordinates.size());
    for (Eigen::Index j = 0; j < size; ++j) {
        const int column = coordinates[j];
        const int at_column = numbering_.equation(column);
        if (at_column < 0) continue;
        const int b = numbering_.block(column);
        const int offset = pattern_.column_offset(b, at_column - pattern_.first(b));
        int a = -1, base = 0;  // neighbouring rows share them
        for (Eigen::Index i = 0; i < size; ++i) {
            const int row = coordinates[i];
            const int at_row = numbering_.equation(row);
            if (local(i, j) == 0.0 || at_row < 0) continue;
            if (pattern_.storage() == Storage::lower && at_row < at_column) continue;
            if (a != numbering_.block(row)) {
                a = numbering_.block(row);
                base = pattern_.base(a, b) + offset - pattern_.first(a);
            }
            matrix.valuePtr()[base + at_row] += scale * local(i, j);
        }
    }
}

template <class Visitor>
void Assembly::for_each_load(const VectorX& q, const VectorX& v, double time, bool derivatives,
                             const Visitor& visit) const {
    LoadState local;
    LoadResult result;
    local.time = time;
    local.derivatives = derivatives;
    for (std::size_t k = 0; k < load_coordinates_.size(); ++k) {
        const detail::LocalCoordinates& coordinates = load_coordinates_[k];
        const auto size = static_cast<Eigen::Index>(coordinates.read().size());
        detail::gather(q, coordinates.read(), local.q);
        detail::gather(v, coordinates.read(), local.v);
        const AnyLoad& load = model_.loads()[k].load;
        const Eigen::Index rows = load.constant() ? 0 : size;
        result.force.setZero(size);
        result.stiffness.setZero(rows, rows);
        result.damping.setZero(rows, rows);
        result.potential = result.period = 0.0;
        load.evaluate(local, result);
        coordinates.carry(result.force);
        coordinates.carry(result.stiffness);
        coordinates.carry(result.damping);
        visit(model_.loads()[k], coordinates.acted(), result);
    }
}

ANCF_INLINE void Assembly::add_loads(const Configuration& at, Request request) {
    angles_.clear();
    faulty_load_ = -1;
    int place = -1;
    for_each_load(
        at.q, at.v, at.instant.time, request != Request::force,
        [&](const ScaledLoad& load, const List<int>& coordinates, const LoadResult& result) {
            const double scale = load.scale(at.instant);
            const int size = static_cast<int>(coordinates.size());
            ++place;
            load_potential_ += scale * result.potential;
            const bool finite =
                std::isfinite(scale * result.potential) && detail::all_finite(result.force) &&
                (request == Request::force ||
                 (detail::all_finite(result.stiffness) && detail::all_finite(result.damping)));
            if (faulty_load_ < 0 && !finite) faulty_load_ = place;
            if (result.period > 0.0) angles_.push_back({scale, result.potential, result.period});
            for (int i = 0; i < size; ++i) external_[coordinates[i]] += scale * result.force[i];
            if (request == Request::force || result.stiffness.size() == 0) return;
            add_matrix(coordinates, -scale, result.stiffness, tangent_);
            if (request == Request::tangent_and_damping)
                add_matrix(coordinates, -scale, result.damping, damping_);
        });
}

ANCF_INLINE VectorX Assembly::load_rate(const VectorX& q, double factor, double side) const {
    check_size("load_rate", "coordinates", q);
    const double gravity =
        detail::slope_of([&](const Instant& at) { return model_.gravity_scale(at); }, factor, side);
    VectorX rate = gravity_;
    for (double& entry : rate) entry *= gravity;
    for_each_load(
        q, VectorX::Zero(q.size()), factor, false,
        [&](const ScaledLoad& load, const List<int>& coordinates, const LoadResult& result) {
            const double scale =
                detail::slope_of([&](const Instant& at) { return load.scale(at); }, factor, side);
            for (std::size_t i = 0; i < coordinates.size(); ++i)
                rate[coordinates[i]] += scale * result.force[static_cast<Eigen::Index>(i)];
        });
    return rate;
}

ANCF_INLINE void Assembly::add_load_tangent_rate(const VectorX& q, SparseMatrix& matrix) const {
    check_size("add_load_tangent_rate", "coordinates", q);
    for_each_load(
        q, VectorX::Zero(q.size()), 0.0, true,
        [&](const ScaledLoad& load, const List<int>& coordinates, const LoadResult& result) {
            if (result.stiffness.size() == 0) return;
            const double scale =
                detail::slope_of([&](const Instant& at) { return load.scale(at); }, 0.0, 1.0);
            add_matrix(coordinates, -scale, result.stiffness, matrix);
        });
}

ANCF_INLINE void Assembly::add_load_tangent_change(const VectorX& q, const VectorX& change,
                                                   double scale, SparseMatrix& matrix) const {
    check_size("add_load_tangent_change", "coordinates", q);
    constexpr double round_off = 64.0 * std::numeric_limits<double>::epsilon();
    const VectorX rest = VectorX::Zero(q.size());
    SparseMatrix sum = tangent_;
    for (int k = 0; k < detail::entries(sum); ++k) sum.valuePtr()[k] = 0.0;
    SparseMatrix noise = sum;
    for (const double sign : {-1.0, 1.0})
        for_each_load(
            q + sign * change, rest, 0.0, true,
            [&](const ScaledLoad& load, const List<int>& coordinates, const LoadResult& result) {
                MatrixX block = -scale * load.scale({0.0, 0.0}) * result.stiffness;
                if (block.size() == 0) return;
                add_matrix(coordinates, sign, block, sum);
                block.setConstant(round_off * block.cwiseAbs().maxCoeff());
                add_matrix(coordinates, 1.0, block, noise);
            });
    for (int k = 0; k < detail::entries(sum); ++k)
        if (std::abs(sum.valuePtr()[k]) > noise.valuePtr()[k])
            matrix.valuePtr()[k] += sum.valuePtr()[k];
}

ANCF_INLINE int Assembly::damping_load(const VectorX& q, const VectorX& v, const VectorX& others,
                                       double time) const {
    check_size("damping_load", "coordinates", q);
    List<VectorX> forces;
    const auto keep = [&](const ScaledLoad&, const List<int>&, const LoadResult& result) {
        forces.push_back(result.force);
    };
    for_each_load(q, v, time, false, keep);
    for_each_load(q, others, time, false, keep);
    const std::size_t loads = load_coordinates_.size();
    for (std::size_t k = 0; k < loads; ++k)
        if (detail::all_finite(forces[k]) && forces[k] != forces[loads + k])
            return static_cast<int>(k);
    return -1;
}

ANCF_INLINE void Assembly::add_constraints(const Configuration& at, Request request) {
    violation_.setZero(numbering_.multipliers());
    violation_rate_.setZero(numbering_.multipliers());
    faulty_constraint_ = -1;
    steepest_.assign(static_cast<std::size_t>(numbering_.multipliers()), {});
    ConstraintState& local = constraint_state_;
    ConstraintResult& result = constraint_result_;
    local.time = at.instant.time;
    int first = 0;
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        const AnyConstraint& constraint = model_.constraints()[k];
        const detail::LocalCoordinates& map = constraint_coordinates_[k];
        const List<int>& coordinates = map.acted();
        const int equations = constraint.equations();
        detail::gather(at.q, map.read(), local.q);
        detail::gather(at.v, map.read(), local.v);
        local.multipliers.resize(equations);
        std::copy_n(at.multipliers.data() + first, equations, local.multipliers.data());
        const bool terms_alone = request == Request::force;
        if (terms_alone) {
            constraint.terms(local, result);
        } else {
            constraint.evaluate(local, result);
        }
        map.carry_columns(result.jacobian);
        const Eigen::Index size = result.jacobian.cols();
        std::copy_n(result.violation.data(), equations, violation_.data() + first);
        std::copy_n(result.rate.data(), equations, violation_rate_.data() + first);
        if (faulty_constraint_ < 0 &&
            !(detail::all_finite(result.violation) && detail::all_finite(result.jacobian) &&
              (terms_alone || detail::all_finite(result.stiffness))))
            faulty_constraint_ = static_cast<int>(k);
        for (Eigen::Index i = 0; i < size; ++i)
            for (int e = 0; e < equations; ++e)
                constraint_[coordinates[i]] += result.jacobian(e, i) * local.multipliers[e];
        for (Eigen::Index i = 0; i < size; ++i)
            for (int e = 0; e < equations; ++e) {
                const int power = constraint_powers_[k][i];
                double& most = steepest_[first + e][power + 1];
                most = std::max(most, std::abs(result.jacobian(e, i)));
            }
        if (!terms_alone) add_constraint_blocks(static_cast<int>(k), result);
        first += equations;
    }
}

ANCF_INLINE VectorX Assembly::violation_scale(double length) const {
    VectorX scale(numbering_.multipliers());
    for (std::size_t e = 0; e < steepest_.size(); ++e)
        scale[static_cast<Eigen::Index>(e)] =
            std::max({steepest_[e][0] / length, steepest_[e][1], steepest_[e][2] * length});
    return scale;
}

ANCF_INLINE void Assembly::add_constraint_blocks(int constraint, ConstraintResult& result) {
    const detail::LocalCoordinates& map = constraint_coordinates_[constraint];
    const List<int>& stiff = map.carry(result.stiffness, result.active);
    add_matrix(stiff, 1.0, result.stiffness, tangent_);
    double* const values = tangent_.valuePtr();
    visit_border(constraint, map.acted(), [&](int i, int j, int place, int mirrored) {
        values[place] += result.jacobian(i, j);
        values[mirrored] += result.jacobian(i, j);
    });
}

ANCF_INLINE std::optional<Fault> Assembly::inspect(const VectorX& q) const {
    check_size("inspect", "coordinates", q);
    Status status = Status::converged;
    const auto found =
        find_element(q, [&](const ElementGroup& group, int prototype, const double* e) {
            bool finite = true;
            for (int i = 0; i < group.dofs(); ++i) finite = finite && std::isfinite(e[i]);
            status = !finite                          ? Status::not_finite
                     : group.admissible(prototype, e) ? Status::converged
                                                      : Status::degenerate;
            return status != Status::converged;
        });
    if (!found) return std::nullopt;
    return Fault{status, found->group, found->element,
                 status == Status::not_finite ? faulty_support(q) : -1};
}

ANCF_INLINE std::optional<Fault> Assembly::inspect_values(const VectorX& q) const {
    check_size("inspect_values", "coordinates", q);
    const auto found =
        find_element(q, [](const ElementGroup& group, int prototype, const double* e) {
            const int dofs = group.dofs();
            VectorX values(dofs * (dofs + 2) + 2);  // energies, forces, tangent
            double* const force = values.data() + 2;
            values[0] = group.energy(prototype, e);
            group.force(prototype, e, force);
            values[1] = group.evaluate(prototype, e, force + dofs, force + 2 * dofs);
            return !detail::all_finite(values);
        });
    if (!found) return std::nullopt;
    return Fault{Status::not_finite, found->group, found->element};
}

ANCF_INLINE int Assembly::faulty_support(const VectorX& entries) const {
    const auto& supports = model_.supports();
    for (int k = 0; k < static_cast<int>(supports.size()); ++k) {
        const Support& held = supports[static_cast<std::size_t>(k)];
        const int at = model_.coordinate(held.node, held.field) + held.component;
        if (held.value && !std::isfinite(entries[at])) return k;
    }
    return -1;
}

ANCF_INLINE std::optional<Fault> Assembly::inspect_parts(const VectorX& q) const {
    const auto own = [&] { return inspect(q); };
    return model_.exchange() == nullptr ? own() : detail::worst_of_parts(*model_.exchange(), own);
}

ANCF_INLINE std::string Assembly::describe(const Fault& fault) const {
    const detail::Exchange* const exchange = model_.exchange();
    if (fault.support >= 0) {
        const Support& support = model_.supports()[static_cast<std::size_t>(fault.support)];
        return detail::joined({"the support of ", to_string(support.field), ", component ",
                               support.component, ", of node ", support.node.index,
                               " has a value, rate or acceleration that is not finite"});
    }
    if (fault.element >= 0)
        return detail::joined(
            {"element ",
             exchange == nullptr ? fault.element : exchange->element(fault.group, fault.element),
             " of the type ", model_.groups()[fault.group]->name(), " is ",
             to_string(fault.status)});
    if (faulty_load_ >= 0)
        return detail::joined(
            {!detail::all_finite(external_)   ? "the force of load "
             : std::isfinite(load_potential_) ? "a derivative of the force of load "
                                              : "the potential of load ",
             exchange == nullptr ? faulty_load_ : exchange->load(faulty_load_), " is not finite"});
    if (faulty_constraint_ >= 0) {
        const auto at = static_cast<std::size_t>(faulty_constraint_);
        return detail::joined(
            {!detail::all_finite(violation_)   ? "the value of constraint "
             : detail::all_finite(constraint_) ? "the stiffness of constraint "
                                               : "the direction of constraint ",
             exchange == nullptr ? faulty_constraint_ : exchange->constraint(faulty_constraint_),
             " (", model_.constraints()[at].name(),
             ") is not finite: do points or directions coincide?"});
    }
    return detail::joined({"gravity, a coordinate or a multiplier is ", to_string(fault.status)});
}

ANCF_INLINE std::optional<ElementPlace> Assembly::softened(const VectorX& q) const {
    check_size("softened", "coordinates", q);
    return find_element(q, [](const ElementGroup& group, int prototype, const double* e) {
        return group.softened(prototype, e);
    });
}

ANCF_INLINE double Assembly::largest_turn(const VectorX& q) const {
    check_size("largest_turn", "coordinates", q);
    const Layout& layout = model_.layout();
    double least = 1.0;  // cosine
    for (const auto& group : model_.groups()) {
        if (!group->fields().contains(Field::r_x)) continue;
        for (const Connection& connection : group->connections) {
            const double* a = q.data() + layout.index({connection.first, Field::r_x});
            const double* b = q.data() + layout.index({connection.second, Field::r_x});
            double aa = 0.0, ab = 0.0, bb = 0.0;
            for (int i = 0; i < model_.dimension(); ++i) {
                aa += a[i] * a[i];
                ab += a[i] * b[i];
                bb += b[i] * b[i];
            }
            const double lengths = std::sqrt(aa) * std::sqrt(bb);
            if (lengths > 0.0) least = std::min(least, ab / lengths);
        }
    }
    if (model_.exchange() != nullptr) least = -model_.exchange()->largest(-least);
    return std::acos(std::max(least, -1.0));
}

ANCF_INLINE std::optional<ElementPlace> Assembly::find_element(const VectorX& q,
                                                               const Judge& judge) const {
    double e[ElementGroup::max_dofs];
    for (std::size_t g = 0; g < plans_.size(); ++g) {
        const ElementGroup& group = *model_.groups()[g];
        for (int k = 0; k < group.size(); ++k) {
            const ElementPlace place{static_cast<int>(g), k};
            gather_element(place, q, e);
            if (judge(group, group.prototype_of(k), e)) return place;
        }
    }
    return std::nullopt;
}

ANCF_INLINE void Assembly::residual(VectorX& out) const {
    out.resize(numbering_.unknowns());
    for (int k = 0; k < numbering_.coordinates(); ++k)
        if (const int equation = numbering_.equation(k); equation >= 0)
            out[equation] = unbalanced(k);
    std::copy_n(violation_.data(), violation_.size(), out.data() + numbering_.free_coordinates());
}

ANCF_INLINE void Assembly::predicted_residual(VectorX& out) const {
    residual(out);
    for (int k = 0; k < static_cast<int>(predicted_.size()); ++k)
        if (const int equation = numbering_.equation(k); equation >= 0)
            out[equation] += predicted_[k] - internal_[k];
}

ANCF_INLINE SparseMatrix Assembly::mass() const {
    check_scene();
    SparseMatrix result = pattern_.matrix();
    for (std::size_t g = 0; g < plans_.size(); ++g) {
        const ElementGroup& group = *model_.groups()[g];
        const std::ptrdiff_t size = group.dofs() * group.dofs();
        const List<double> masses = detail::prototype_masses(group);
        for (int k = 0; k < group.size(); ++k)
            add_block({static_cast<int>(g), k}, masses.data() + size * group.prototype_of(k),
                      result);
    }
    for (const PointMass& point : model_.masses()) {
        const detail::LocalCoordinates at(model_.layout(), model_.dependence(),
                                          {{point.node, Field::r}}, "mass");
        MatrixX block = MatrixX::Identity(model_.dimension(), model_.dimension());
        at.carry(block);
        add_matrix(at.acted(), point.mass, block, result);
    }
    return result;
}

ANCF_INLINE VectorX Assembly::mass_product(const VectorX& a) const {
    check_size("mass_product", "coordinates", a);
    VectorX result = VectorX::Zero(a.size());
    for (std::size_t g = 0; g < plans_.size(); ++g) {
        const ElementGroup& group = *model_.groups()[g];
        const int dofs = group.dofs();
        const List<double> masses = detail::prototype_masses(group);
        for_each_element(g, [&](const ElementPlace& at, const int* indices) {
            const double* mass = masses.data() + static_cast<std::ptrdiff_t>(dofs) * dofs *
                                                     group.prototype_of(at.element);
            double e[ElementGroup::max_dofs];
            for (int i = 0; i < dofs; ++i) e[i] = a[indices[i]];
            for (int j = 0; j < dofs; ++j)
                for (int i = 0; i < dofs; ++i) result[indices[i]] += *mass++ * e[j];
        });
    }
    for (const PointMass& point : model_.masses()) {
        const int at = model_.coordinate(point.node, Field::r);
        for (int i = 0; i < model_.dimension(); ++i) result[at + i] += point.mass * a[at + i];
    }
    numbering_.dependence().carry(result);
    if (model_.exchange() != nullptr) model_.exchange()->add(result);
    return result;
}

ANCF_INLINE void Assembly::apply_supports(const Instant& instant, VectorX& q) const {
    check_scene();
    detail::require(q.size() == numbering_.coordinates(), "the state has ", q.size(),
                    " coordinates, the model has ", numbering_.coordinates());
    for (const Support& support : model_.supports())
        if (support.value)
            q[model_.layout().index({support.node, support.field}) + support.component] =
                support.value(instant.time);
    numbering_.dependence().complete(q);
}

}  // namespace ancf
