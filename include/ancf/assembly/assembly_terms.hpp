// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Assembly: loads, constraints, supports and inertia; the residual.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/error.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace ancf {

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
        detail::gather(q, coordinates, local.q);
        detail::gather(v, coordinates, local.v);
        const AnyLoad& load = model_.loads()[k].load;
        const Eigen::Index rows = load.constant() ? 0 : size;
        result.force.setZero(size);
        result.stiffness.setZero(rows, rows);
        result.damping.setZero(rows, rows);
        result.potential = result.period = 0.0;
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
    angles_.clear();
    faulty_load_ = -1;
    int place = -1;
    for_each_load(
        at.q, at.v, at.instant.time, request != Request::force,
        [&](const ScaledLoad& load, const std::vector<int>& coordinates, const LoadResult& result) {
            const double scale = load.scale(at.instant);
            const int size = static_cast<int>(coordinates.size());
            ++place;
            load_potential_ += scale * result.potential;
            if (faulty_load_ < 0 && !(std::isfinite(scale) && result.force.allFinite()))
                faulty_load_ = place;
            if (result.period > 0.0) angles_.push_back({scale, result.potential, result.period});
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
    check_size("load_rate", "coordinates", q);
    const double step = detail::factor_step(factor);
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
    faulty_constraint_ = -1;
    steepest_.assign(static_cast<std::size_t>(numbering_.multipliers()), {});
    ConstraintState local;
    ConstraintResult result;
    local.time = at.instant.time;
    int first = 0;
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        const AnyConstraint& constraint = model_.constraints()[k];
        const std::vector<int>& coordinates = constraint_coordinates_[k];
        const auto size = static_cast<Eigen::Index>(coordinates.size());
        const int equations = constraint.equations();
        detail::gather(at.q, coordinates, local.q);
        detail::gather(at.v, coordinates, local.v);
        local.multipliers = at.multipliers.segment(first, equations);
        result.reset(equations, size);
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
        if (faulty_constraint_ < 0 &&
            !(result.violation.allFinite() && result.jacobian.allFinite()))
            faulty_constraint_ = static_cast<int>(k);
        for (Eigen::Index i = 0; i < size; ++i)
            for (int e = 0; e < equations; ++e)
                constraint_[coordinates[static_cast<std::size_t>(i)]] +=
                    result.jacobian(e, i) * local.multipliers[e];
        for (Eigen::Index i = 0; i < size; ++i)
            for (int e = 0; e < equations; ++e) {
                const int power = constraint_powers_[k][static_cast<std::size_t>(i)];
                double& most = steepest_[static_cast<std::size_t>(first + e)]
                                        [static_cast<std::size_t>(power + 1)];
                most = std::max(most, std::abs(result.jacobian(e, i)));
            }
        if (request != Request::force) add_constraint_blocks(static_cast<int>(k), result);
        first += equations;
    }
}

template <class Scene>
VectorX Assembly<Scene>::violation_scale(double length) const {
    VectorX scale(numbering_.multipliers());
    for (std::size_t e = 0; e < steepest_.size(); ++e)
        scale[static_cast<Eigen::Index>(e)] =
            std::max({steepest_[e][0] / length, steepest_[e][1], steepest_[e][2] * length});
    return scale;
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
void Assembly<Scene>::check_size(const char* call, const char* what, const VectorX& given) const {
    detail::require(given.size() == numbering_.coordinates(), "Assembly::", call, ": expected ",
                    numbering_.coordinates(), " ", what, ", got ", given.size());
}

template <class Scene>
std::optional<Fault> Assembly<Scene>::inspect(const VectorX& q) const {
    check_size("inspect", "coordinates", q);
    Status status = Status::converged;
    const auto found = find_element(q, [&](const auto& element, const auto& e) {
        status = !e.allFinite()          ? Status::not_finite
                 : element.admissible(e) ? Status::converged
                                         : Status::degenerate;
        return status != Status::converged;
    });
    if (!found) return std::nullopt;
    return Fault{status, found->group, found->element};
}

template <class Scene>
std::string Assembly<Scene>::describe(const Fault& fault) const {
    if (fault.element >= 0) return detail::fault_text(fault);
    if (faulty_load_ >= 0)
        return detail::joined({"the force of load ", faulty_load_, " is not finite"});
    if (faulty_constraint_ >= 0) {
        const auto at = static_cast<std::size_t>(faulty_constraint_);
        return detail::joined({"the direction of constraint ", faulty_constraint_, " (",
                               model_.constraints()[at].name(),
                               ") is not finite: do points coincide?"});
    }
    return detail::fault_text(fault);
}

template <class Scene>
std::optional<ElementPlace> Assembly<Scene>::softened(const VectorX& q) const {
    check_size("softened", "coordinates", q);
    return find_element(q, [](const auto& element, const auto& e) {
        if constexpr (detail::TellsSoftened<std::decay_t<decltype(element)>>::value)
            return element.softened(e);
        else
            return false;
    });
}

template <class Scene>
double Assembly<Scene>::largest_turn(const VectorX& q) const {
    check_size("largest_turn", "coordinates", q);
    double least = 1.0;  // cosine
    model_.for_each_group([&](const auto& group) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        if constexpr (Element::fields.contains(Field::r_x)) {
            const auto slope = [&](NodeId node) -> Vector<double, Scene::dimension> {
                return q.template segment<Scene::dimension>(
                    model_.layout().index({node, Field::r_x}));
            };
            for (const Connection& connection : group.connections) {
                const auto first = slope(connection.first), second = slope(connection.second);
                const double lengths = first.norm() * second.norm();
                if (lengths > 0.0) least = std::min(least, first.dot(second) / lengths);
            }
        }
    });
    return std::acos(std::max(least, -1.0));
}

template <class Scene>
template <class Judge>
std::optional<ElementPlace> Assembly<Scene>::find_element(const VectorX& q,
                                                          const Judge& judge) const {
    int group_index = 0;
    std::optional<ElementPlace> place;
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        int coordinate[Element::dofs];
        typename Element::Coordinates e;
        for (std::size_t k = 0; k < slots.size() && !place; ++k) {
            element_coordinates<Element>(slots[k], coordinate);
            for (int i = 0; i < Element::dofs; ++i) e[i] = q[coordinate[i]];
            const int index = static_cast<int>(k);
            if (judge(group.element(index), e)) place = ElementPlace{group_index, index};
        }
        ++group_index;
    });
    return place;
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
    check_size("mass_product", "coordinates", a);
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
            const auto& mass = masses[static_cast<std::size_t>(group.connections[k].prototype)];
            for (int j = 0; j < Element::dofs; ++j)
                for (int i = 0; i < Element::dofs; ++i) result[coordinate[i]] += mass(i, j) * e[j];
        }
    });
    for (const PointMass& point : model_.masses()) {
        const int at = model_.coordinate(point.node, Field::r);
        for (int i = 0; i < Scene::dimension; ++i) result[at + i] += point.mass * a[at + i];
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
