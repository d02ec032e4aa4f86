// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf {

ANCF_INLINE Amplitude tabular_amplitude(List<std::pair<double, double>> points) {
    detail::require(!points.empty(), "tabular_amplitude: at least one point is needed");
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto [time, value] = points[k];
        detail::require(std::isfinite(time) && std::isfinite(value), "tabular_amplitude: point ", k,
                        " must be finite, got ", time, ", ", value);
        detail::require(k == 0 || time > points[k - 1].first,
                        "tabular_amplitude: times must rise, point ", k, " is at ", time,
                        ", the one before at ", points[k - 1].first);
    }
    return [points = std::move(points)](double time) {
        const auto next = std::upper_bound(
            points.begin(), points.end(), time,
            [](double now, const std::pair<double, double>& point) { return now < point.first; });
        if (next == points.begin()) return points.front().second;
        if (next == points.end()) return points.back().second;
        const auto [from, low] = next[-1];
        const auto [to, high] = *next;
        const double share = (time - from) / (to - from);
        return (1.0 - share) * low + share * high;
    };
}

ANCF_INLINE Scene::Scene(int dimension) noexcept : dimension_(dimension) {}

ANCF_INLINE Scene::~Scene() = default;

ANCF_INLINE Scene::Scene(const Scene& other) = default;

ANCF_INLINE Scene::Scene(Scene&& other) noexcept : dimension_(other.dimension_) {
    swap(other);
    other.revision_ = {revision_.scene + 1, revision_.properties + 1};
}

ANCF_INLINE Scene& Scene::operator=(const Scene& other) { return *this = Scene(other); }

ANCF_INLINE Scene& Scene::operator=(Scene&& other) {
    detail::require(other.dimension_ == dimension_, "Model: a scene of dimension ",
                    other.dimension_, " cannot replace one of dimension ", dimension_);
    const Revision next{std::max(revision_.scene, other.revision_.scene) + 1,
                        std::max(revision_.properties, other.revision_.properties) + 1};
    Scene taken(std::move(other));
    swap(taken);
    revision_ = next;
    return *this;
}

ANCF_INLINE void Scene::swap(Scene& other) noexcept { std::swap<SceneContents>(*this, other); }

ANCF_INLINE std::unique_ptr<Scene> Scene::part(
    const ScenePart& held, std::shared_ptr<const detail::Exchange> exchange) const {
    detail::require(held.nodes.size() == initial_.size() && held.elements.size() == groups_.size(),
                    "Scene::part: expected ", initial_.size(), " nodes and ", groups_.size(),
                    " groups, got ", held.nodes.size(), " and ", held.elements.size());
    const auto has = [&](NodeId node) { return held.nodes[node.index] != 0; };
    std::unique_ptr<Scene> part(new Scene(dimension_));
    part->initial_ = initial_;
    for (std::size_t k = 0; k < initial_.size(); ++k) {
        InitialNode& node = part->initial_[k];
        if (held.nodes[k] == 0) node.fields = Fields();
        node.last_support = node.last_attachment = -1;
    }
    for (std::size_t k = 0; k < groups_.size(); ++k) {
        part->groups_.push_back(groups_[k]->clone());
        List<Connection>& connections = part->groups_.back()->connections;
        connections = {};
        for (const int element : held.elements[k])
            connections.push_back(groups_[k]->connection(element));
    }
    for (const Support& support : supports_) {
        if (!has(support.node)) continue;
        part->append(support);
    }
    for (const AttachedVector& attachment : attachments_) {
        if (!has(attachment.vector.node)) continue;
        detail::require(has(attachment.to), "Scene::part: node ", attachment.vector.node.index,
                        " follows node ", attachment.to.index, ", which is no part");
        part->append(attachment);
    }
    for (const int k : held.loads) part->loads_.push_back(loads_[k]);
    for (const int k : held.constraints) part->constraints_.push_back(constraints_[k]);
    for (const int k : held.masses) part->masses_.push_back(masses_[k]);
    part->gravity_ = gravity_;
    part->gravity_amplitude_ = gravity_amplitude_;
    part->exchange_ = std::move(exchange);
    State& to = part->state();
    const State& from = state();
    for (int node = 0; node < nodes(); ++node) {
        const int first = part->layout_.first(node), size = part->layout_.size(node);
        for (int k = 0; k < size; ++k) {
            to.q[first + k] = from.q[layout_.first(node) + k];
            to.v[first + k] = from.v[layout_.first(node) + k];
        }
    }
    to.time = from.time;
    List<int> first = {0};  // multiplier of each constraint
    for (const AnyConstraint& constraint : constraints_)
        first.push_back(first.back() + constraint.equations());
    Eigen::Index next = 0;
    for (const int k : held.constraints)
        for (int i = first[k]; i < first[static_cast<std::size_t>(k) + 1]; ++i)
            to.multipliers[next++] = from.multipliers[i];
    return part;
}

ANCF_INLINE NodeId Scene::add_initial_node(const std::array<double, 3 * field_count>& vectors) {
    InitialNode node;
    node.vectors = vectors;
    initial_.push_back(node);
    layout_stale_ = state_stale_ = true;
    ++revision_.scene;
    return {nodes() - 1};
}

ANCF_INLINE void Scene::set_gravity_components(const std::array<double, 3>& gravity,
                                               Amplitude amplitude) {
    gravity_ = gravity;
    gravity_amplitude_ = std::move(amplitude);
    ++revision_.properties;
}

ANCF_INLINE void Scene::reject_group(std::string_view name) const {
    std::string known;
    for (const auto& group : groups_)
        known += (known.empty() ? "" : ", ") + std::string(group->name());
    detail::reject("the model has no element of the type ", name, ", it has ",
                   known.empty() ? std::string("none") : known);
}

ANCF_INLINE int Scene::connect_in(ElementGroup* group, int prototype, NodeId first, NodeId second) {
    check(first);
    check(second);
    const bool one_node = group != nullptr && group->one_node();
    detail::require(one_node || first != second,
                    "Model::connect: an element joins two nodes, got node ", first.index, " twice");
    detail::require(!one_node || first == second, "Model::connect: an element of one node stands ",
                    "between that node and itself, got nodes ", first.index, " and ", second.index);
    const int prototypes = group == nullptr ? 0 : group->prototype_count();
    detail::require(prototype >= 0 && prototype < prototypes, "Model::connect: there are ",
                    prototypes, " prototypes, got index ", prototype);
    for (const NodeId node : {first, second}) check_widening("connect", node, group->fields());
    group->connections.push_back({prototype, first, second});
    for (const NodeId node : {first, second}) {
        widen(node, group->fields());
        // stiffnesses of several groups are summed in the order of the groups
        rebuild_ = rebuild_ || (groups_.size() > 1 && node.index < layout_.nodes());
    }
    layout_stale_ = state_stale_ = true;
    ++revision_.scene;
    return group->size() - 1;
}

ANCF_INLINE bool Scene::has_own_prototype(const ElementGroup& group, int element) {
    // outwards: equal elements mostly stand side by side
    const int shared = group.prototype_of(element);
    for (int apart = 1; apart < group.size(); ++apart)
        for (const int other : {element - apart, element + apart})
            if (other >= 0 && other < group.size() && group.prototype_of(other) == shared)
                return false;
    return true;
}

ANCF_INLINE void Scene::check_prototype(const ElementGroup& group, int index) {
    detail::require(index >= 0 && index < group.prototype_count(), "Model: there are ",
                    group.prototype_count(), " prototypes, got index ", index);
}

ANCF_INLINE void Scene::fix(NodeId node, Fields fields) {
    for (int k = 0; k < fields.count(); ++k)
        for (int component = 0; component < dimension_; ++component)
            fix(node, fields.at(k), component);
}

ANCF_INLINE void Scene::fix(NodeId node, Field field, int component) {
    prescribe(node, field, component, {});
}

ANCF_INLINE void Scene::prescribe(NodeId node, Field field, int component, Amplitude value,
                                  Amplitude rate, Amplitude acceleration) {
    check(node);
    detail::require(component >= 0 && component < dimension_, "Model: a vector has ", dimension_,
                    " components, got component ", component);
    check_unattached("prescribe", node, field);
    detail::require(value || !(rate || acceleration), "Model::prescribe: ", to_string(field),
                    ", component ", component, ", of node ", node.index,
                    " has a rate or an acceleration and no value");
    Support support{
        node, field, component, std::move(value), std::move(rate), std::move(acceleration)};
    if (const int place = support_of(node, field, component); place >= 0)
        supports_[place] = std::move(support);
    else
        append(std::move(support));
    ++revision_.scene;
}

ANCF_INLINE int Scene::support_of(NodeId node, Field field, int component) const noexcept {
    int place = initial_[node.index].last_support;
    for (; place >= 0; place = support_before_[place]) {
        const Support& support = supports_[place];
        if (support.field == field && support.component == component) break;
    }
    return place;
}

ANCF_INLINE void Scene::append(Support support) {
    InitialNode& node = initial_[support.node.index];
    support_before_.push_back(node.last_support);
    node.last_support = static_cast<int>(supports_.size());
    supports_.push_back(std::move(support));
}

ANCF_INLINE void Scene::append(const AttachedVector& attachment) {
    InitialNode& node = initial_[attachment.vector.node.index];
    attachment_before_.push_back(node.last_attachment);
    node.last_attachment = static_cast<int>(attachments_.size());
    attachments_.push_back(attachment);
}

ANCF_INLINE void Scene::clamp(NodeId node, Clamp clamp) {
    check(node);
    const Fields carried = initial_[node.index].fields;
    detail::require(!(carried == Fields()), "Model::clamp: node ", node.index,
                    " carries no vectors yet; connect its elements first");
    for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z}) {
        const bool held = clamp == Clamp::full || field != Field::r_x;
        if (held && carried.contains(field)) fix(node, field);
    }
    initial_[node.index].held = true;
}

ANCF_INLINE void Scene::release(NodeId node, Field field) {
    check(node);
    check_unattached("release", node, field);
    List<Support> before;
    std::swap(before, supports_);
    support_before_.clear();
    for (const Support& support : before) initial_[support.node.index].last_support = -1;
    for (Support& support : before)
        if (support.node != node || support.field != field) append(std::move(support));
    initial_[node.index].held = false;
    ++revision_.scene;
}

ANCF_INLINE void Scene::attach(NodeId end, NodeId joint) {
    check(end);
    const Fields carried = initial_[end.index].fields;
    detail::require(carried.contains(Field::r), "Model::attach: node ", end.index,
                    " carries no vectors yet; connect its elements or add its mass first");
    Fields vectors = Field::r;
    for (const Field slope : {Field::r_y, Field::r_z})
        if (carried.contains(slope)) vectors = vectors | slope;
    if (dimension_ == 3 && carried.contains(Field::r_y) && !carried.contains(Field::r_z))
        vectors = vectors | Field::r_x;
    attach(end, joint, vectors);
    initial_[end.index].held = true;
}

ANCF_INLINE void Scene::attach(NodeId end, NodeId joint, Fields vectors) {
    check(end);
    check(joint);
    detail::require(!(vectors == Fields()), "Model::attach: name at least one vector of node ",
                    end.index, " to attach to node ", joint.index, ", got none");
    for (int k = 0; k < vectors.count(); ++k) check_attachment(end, joint, vectors.at(k));
    const auto& from = initial_[end.index].vectors;
    const auto& to = initial_[joint.index].vectors;
    // sums of a user's coordinates: what round-off leaves of an offset is none
    constexpr double round_off = 1e-12;
    List<AttachedVector> attachments;
    Fields followed;
    for (int k = 0; k < vectors.count(); ++k) {
        const Field field = vectors.at(k);
        double vector[3] = {};
        double size = 0.0;  // of what the vector is the difference of
        for (std::size_t i = 0; i < 3; ++i) {
            const double base = field == Field::r ? to[i] : 0.0;
            vector[i] = from[3 * static_cast<std::size_t>(field) + i] - base;
            size = std::max({size, std::abs(base), std::abs(vector[i])});
        }
        for (double& entry : vector)
            if (std::abs(entry) <= round_off * size) entry = 0.0;
        const std::array<double, 3> slopes = by_slopes(joint, vector);
        AttachedVector attachment{{end, field}, joint, {field == Field::r ? 1.0 : 0.0}};
        for (std::size_t i = 0; i < 3; ++i) {
            const double factor = std::abs(slopes[i]) <= round_off * size ? 0.0 : slopes[i];
            attachment.factors[1 + i] = factor;
            if (factor != 0.0) followed = followed | static_cast<Field>(1 + i);
        }
        if (field == Field::r) followed = followed | Field::r;
        attachments.push_back(attachment);
    }
    check_widening("attach", joint, followed);
    widen(joint, followed);
    for (const AttachedVector& attachment : attachments) append(attachment);
    layout_stale_ = state_stale_ = true;
    ++revision_.scene;
}

ANCF_INLINE void Scene::check_attachment(NodeId end, NodeId joint, Field field) const {
    const char* const name = to_string(field);
    detail::require(length_power(field) >= 0, "Model::attach: expected r or slopes, got ", name);
    detail::require(initial_[end.index].fields.contains(field), "Model::attach: node ", end.index,
                    " carries no ", name, "; connect its elements or add its mass first");
    check_unattached("attach", end, field);
    const auto followed_by = [&](NodeId node) {
        const int last = initial_[node.index].last_attachment;
        return last < 0 ? NodeId{} : attachments_[last].to;
    };
    const NodeId other = followed_by(end);
    detail::require(other.index < 0 || other == joint, "Model::attach: node ", end.index,
                    " follows node ", other.index, ", not node ", joint.index, " too");
    for (int component = 0; component < dimension_; ++component)
        detail::require(support_of(end, field, component) < 0, "Model::attach: ", name, " of node ",
                        end.index, " is held or driven; hold node ", joint.index, " instead");
    for (NodeId node = joint; node.index >= 0; node = followed_by(node))
        detail::require(node != end, "Model::attach: nodes ", end.index, " and ", joint.index,
                        " would follow each other in a circle");
}

ANCF_INLINE std::array<double, 3> Scene::by_slopes(NodeId node, const double* v) const {
    // Cramer's rule; in the plane with a third slope normal to it
    const double* const slopes = initial_[node.index].vectors.data() + 3;
    double g[9];
    std::copy_n(slopes, 9, g);
    if (dimension_ == 2) {
        for (const int k : {2, 5, 6, 7}) g[k] = 0.0;
        g[8] = 1.0;
    }
    const auto volume = [](const double* a, const double* b, const double* c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    const double all = volume(g, g + 3, g + 6);
    double size = 1.0;
    for (int k = 0; k < 9; k += 3) size *= std::hypot(g[k], g[k + 1], g[k + 2]);
    detail::require(std::abs(all) > 1e-6 * size, "Model::attach: the slopes of node ", node.index,
                    " are not independent");
    return {volume(v, g + 3, g + 6) / all, volume(g, v, g + 6) / all, volume(g, g + 3, v) / all};
}

ANCF_INLINE void Scene::check_unattached(const char* call, NodeId node, Field field) const {
    if (const AttachedVector* const attached = attachment_of(node, field))
        detail::reject("Model::", call, ": ", to_string(field), " of node ", node.index,
                       " is attached to node ", attached->to.index,
                       ": take that node, or hold this one by a joint such as Pin");
}

ANCF_INLINE const AttachedVector* Scene::attachment_of(NodeId node, Field field) const noexcept {
    if (node.index < 0 || node.index >= nodes()) return nullptr;
    int place = initial_[node.index].last_attachment;
    for (; place >= 0; place = attachment_before_[place]) {
        const AttachedVector& attachment = attachments_[place];
        if (attachment.vector.field == field) return &attachment;
    }
    return nullptr;
}

ANCF_INLINE void Scene::check_dimension(const char* what, int dimension) const {
    detail::require(dimension == 0 || dimension == dimension_, "Model: ", what, " of dimension ",
                    dimension, " in a model of dimension ", dimension_);
}

ANCF_INLINE void Scene::add_load(AnyLoad load, Amplitude amplitude) {
    const Coupling coupling = load.coupling();
    for (const NodeField& at : coupling) check(at.node);
    if (load.settles()) load.settle(layout());
    if (load.constant()) {  // wrong sizes show wherever it stands
        const VectorX zero = VectorX::Zero(dimension_ * static_cast<int>(coupling.size()));
        LoadResult result{zero, {}, {}, 0.0};
        load.evaluate({zero, zero, 0.0, false}, result);
    }
    loads_.push_back({std::move(load), std::move(amplitude)});
    ++revision_.scene;
}

ANCF_INLINE void Scene::add_constraint(AnyConstraint constraint) {
    for (const NodeField& at : constraint.coupling()) check(at.node);
    detail::require(constraint.equations() > 0, "Model::add: constraint ", constraint.name(),
                    " has ", constraint.equations(), " equations, expected at least 1");
    constraints_.push_back(std::move(constraint));
    state_stale_ = true;
    ++revision_.scene;
}

ANCF_INLINE void Scene::add_mass(NodeId node, double mass) {
    check(node);
    detail::require_positive("Model::add_mass: mass", mass);
    masses_.push_back({node, mass});
    ++revision_.properties;
    if (initial_[node.index].fields.contains(Field::r)) return;
    widen(node, Field::r);
    layout_stale_ = state_stale_ = true;
    ++revision_.scene;
}

ANCF_INLINE void Scene::gather_element(const ElementGroup& group, int index, const VectorX& q,
                                       double* e) const {
    const Connection& connection = group.connection(index);
    detail::require(q.size() == layout().size(), "Model::element_coordinates: expected ",
                    layout().size(), " coordinates, got ", q.size());
    for (const NodeId node : {connection.first, connection.second})
        for (int k = 0; k < group.fields().count(); ++k) {
            const int first = layout().index({node, group.fields().at(k)});
            e = std::copy_n(q.data() + first, dimension_, e);
        }
}

ANCF_INLINE int Scene::coordinate(NodeId node, Field field) const {
    check(node);
    const int first = layout().index({node, field});
    detail::require(first >= 0, "Model: node ", node.index, " carries no ", to_string(field),
                    ", as no element there needs it");
    return first;
}

ANCF_INLINE const double* Scene::vector_now(NodeId node, Field field) const {
    const int first = coordinate(node, field);
    if (state_stale_ && state_fits(layout_) && attachment_of(node, field) == nullptr)
        return first < state_.q.size()
                   ? state_.q.data() + first
                   : initial_[node.index].vectors.data() + 3 * static_cast<int>(field);
    check_state(state().q, layout_);
    return state_.q.data() + first;
}

ANCF_INLINE void Scene::check_widening(const char* call, NodeId node, Fields fields) const {
    const InitialNode& at = initial_[node.index];
    detail::require(!at.held || (at.fields | fields) == at.fields, "Model::", call, ": node ",
                    node.index, " would carry more vectors than when it was clamped or attached; ",
                    "connect its elements first");
}

ANCF_INLINE void Scene::widen(NodeId node, Fields fields) {
    Fields& carried = initial_[node.index].fields;
    const Fields all = carried | fields;
    rebuild_ = rebuild_ || (node.index < layout_.nodes() && !(all == carried));
    carried = all;
}

ANCF_INLINE void Scene::refresh() const {
    if (!layout_stale_) return;
    const bool anew = std::exchange(rebuild_, false);
    Layout before;
    if (anew) {
        before = std::exchange(layout_, Layout(dimension_, {}));
        torsion_.clear();
        counted_.clear();
    }
    for (int node = layout_.nodes(); node < nodes(); ++node) layout_.append(initial_[node].fields);
    add_torsion();
    layout_stale_ = false;
    if (anew) fit_state(before);
}

ANCF_INLINE void Scene::add_torsion() const {
    torsion_.resize(initial_.size());
    counted_.resize(groups_.size(), 0);
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (const ElementGroup& group = *groups_[g]; counted_[g] < group.size(); ++counted_[g]) {
            const Connection& connection = group.connections[counted_[g]];
            double own[2];
            group.torsion_stiffness(connection.prototype, own);
            for (const NodeId node : {connection.first, connection.second}) {
                std::array<double, 2>& all = torsion_[node.index];
                for (std::size_t k = 0; k < 2; ++k) all[k] += own[k];
                const double sum = all[0] + all[1];
                layout_.set_torsion_share(node, sum > 0.0 ? all[0] / sum : 0.5);
            }
        }
}

ANCF_INLINE void Scene::fit_state(const Layout& before) const {
    const bool own = state_fits(before);
    const VectorX q = std::exchange(state_.q, VectorX::Zero(layout_.size()));
    const VectorX v = std::exchange(state_.v, VectorX::Zero(layout_.size()));
    for (int node = 0; node < nodes(); ++node)
        for (int k = 0; k < field_count; ++k) {
            const NodeField at{{node}, static_cast<Field>(k)};
            const int to = layout_.index(at);
            if (to < 0) continue;
            const int from = own && node < state_nodes_ ? before.index(at) : -1;
            const double* const vector = initial_[node].vectors.data() + 3 * k;
            for (int i = 0; i < dimension_; ++i) {
                state_.q[to + i] = from >= 0 ? q[from + i] : vector[i];
                if (from >= 0) state_.v[to + i] = v[from + i];
            }
        }
    state_nodes_ = nodes();
    detail::require(own, "Model: the state had another size; now it is that of the nodes as added");
}

ANCF_INLINE void Scene::update_state() const {
    if (!state_stale_) return;
    refresh();
    if (state_nodes_ < nodes() || !state_fits(layout_)) fit_state(layout_);
    dependence_ = Dependence(layout_, attachments_);
    dependence_.complete(state_.q);
    dependence_.complete(state_.v);
    int equations = 0;
    for (const AnyConstraint& constraint : constraints_) equations += constraint.equations();
    const VectorX old = std::exchange(state_.multipliers, VectorX::Zero(equations));
    const auto kept = std::min<Eigen::Index>(equations, old.size());
    std::copy_n(old.data(), kept, state_.multipliers.data());
    state_stale_ = false;
}

ANCF_INLINE void Scene::check_state(const VectorX& of, const Layout& layout) {
    detail::require(of.size() == layout.size(), "Model: the state has ", of.size(),
                    " coordinates or rates, the model has ", layout.size());
}

ANCF_INLINE void Scene::check(NodeId node) const {
    detail::require(node.index >= 0 && node.index < nodes(), "Model: there are ", nodes(),
                    " nodes, got node ", node.index);
}

}  // namespace ancf
