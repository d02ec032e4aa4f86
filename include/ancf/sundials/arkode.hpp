// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The calls of ERKStep, the explicit Runge-Kutta methods of ARKODE, under one name.
///
/// SUNDIALS 7.1 renamed ERKStepX to ARKodeX and deprecates the old names.

#pragma once

#include <ancf/sundials/context.hpp>
#include <ancf/sundials/table.hpp>

#include <arkode/arkode.h>
#include <arkode/arkode_erkstep.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace ancf::sundials::detail {

#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define ANCF_ARKODE(name) ARKode##name  ///< the name of this version
#else
#define ANCF_ARKODE(name) ERKStep##name  ///< the name of this version
#endif

/// The calls.
struct Arkode {
    static constexpr auto free = ANCF_ARKODE(Free);
    static constexpr auto name_of = ANCF_ARKODE(GetReturnFlagName);
    static constexpr auto evolve = ANCF_ARKODE(Evolve);
    static constexpr auto derivative = ANCF_ARKODE(GetDky);
    static constexpr auto set_tolerances = ANCF_ARKODE(SVtolerances);
    static constexpr auto set_user_data = ANCF_ARKODE(SetUserData);
    static constexpr auto set_stop_time = ANCF_ARKODE(SetStopTime);
    static constexpr auto set_fixed_step = ANCF_ARKODE(SetFixedStep);
    static constexpr auto set_first_step = ANCF_ARKODE(SetInitStep);
    static constexpr auto set_min_step = ANCF_ARKODE(SetMinStep);
    static constexpr auto set_max_step = ANCF_ARKODE(SetMaxStep);
    static constexpr auto set_stability = ANCF_ARKODE(SetStabilityFn);
    static constexpr auto set_stable_share = ANCF_ARKODE(SetCFLFraction);
    static constexpr auto set_kept_steps = ANCF_ARKODE(SetFixedStepBounds);
    static constexpr auto set_degree = ANCF_ARKODE(SetInterpolantDegree);
    static constexpr auto set_after_step = ANCF_ARKODE(SetPostprocessStepFn);
    static constexpr auto current_step = ANCF_ARKODE(GetCurrentStep);
    static constexpr auto last_step = ANCF_ARKODE(GetLastStep);
    static constexpr auto error_failures = ANCF_ARKODE(GetNumErrTestFails);
    static constexpr auto limited_steps = ANCF_ARKODE(GetNumExpSteps);
};

#undef ANCF_ARKODE

/// Returns ARKODE's number of a table.
[[nodiscard]] constexpr ARKODE_ERKTableID table_id(Table table) noexcept {
    switch (table) {
        case Table::bogacki_shampine: return ARKODE_BOGACKI_SHAMPINE_4_2_3;
        case Table::zonneveld: return ARKODE_ZONNEVELD_5_3_4;
        case Table::ark437: return ARKODE_ARK437L2SA_ERK_7_3_4;
        case Table::dormand_prince: return ARKODE_DORMAND_PRINCE_7_4_5;
        case Table::verner: return ARKODE_VERNER_8_5_6;
        case Table::fehlberg: return ARKODE_FEHLBERG_13_7_8;
        case Table::ark436: break;
    }
    return ARKODE_ARK436L2SA_ERK_6_3_4;
}

/// Whether the last stage of a table is the first of the next step.
[[nodiscard]] constexpr bool is_first_same_as_last(Table table) noexcept {
    return table == Table::bogacki_shampine || table == Table::dormand_prince;
}

using ArkodeOwner = std::unique_ptr<void, Destroy<Arkode::free>>;  ///< owns the memory of ARKODE

/// Returns an object of ERKStep whose messages go to the context.
[[nodiscard]] inline ArkodeOwner make_erk(Context& context, ARKRhsFn rate, double time,
                                          N_Vector start) {
    ArkodeOwner erk(made(ERKStepCreate(rate, time, start, context.get())));
#if SUNDIALS_VERSION_MAJOR < 7
    ERKStepSetErrHandlerFn(erk.get(), &Context::take, &context);
#endif
    return erk;
}

/// Returns ARKODE's own name of a return code, such as ARK_ERR_FAILURE.
[[nodiscard]] inline std::string arkode_code_name(int code) {
    const std::unique_ptr<char, decltype(&std::free)> name(Arkode::name_of(code), &std::free);
    return name == nullptr ? std::string() : std::string(name.get());
}

}  // namespace ancf::sundials::detail
