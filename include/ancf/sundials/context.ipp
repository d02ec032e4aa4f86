// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of context.hpp.

#pragma once

#include <ancf/sundials/context.hpp>
#include <ancf/sundials/index.hpp>

#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <string>

namespace ancf::sundials {
namespace detail {

/// Passes a new object on, or throws where SUNDIALS returned none.
template <class Handle>
Handle made(Handle handle) {
    if (handle == nullptr) throw std::bad_alloc();
    return handle;
}

}  // namespace detail

ANCF_INLINE VectorOwner make_vector(const Context& context, Eigen::Index size) {
    const auto length = detail::checked_index(size, "unknowns");
    VectorOwner vector(detail::made(N_VNew_Serial(length, context.get())));
    N_VConst(0.0, vector.get());
    return vector;
}

ANCF_INLINE MatrixOwner make_matrix(const Context& context, Eigen::Index size,
                                    Eigen::Index values) {
    const auto length = detail::checked_index(size, "unknowns");
    const auto entries = detail::checked_index(values, "entries of the Jacobian");
    return MatrixOwner(
        detail::made(SUNSparseMatrix(length, length, entries, CSC_MAT, context.get())));
}

ANCF_INLINE LinearSolverOwner make_klu(const Context& context, N_Vector vector, SUNMatrix matrix) {
    return LinearSolverOwner(detail::made(SUNLinSol_KLU(vector, matrix, context.get())));
}

ANCF_INLINE IdaOwner make_ida(Context& context) {
    IdaOwner ida(detail::made(IDACreate(context.get())));
    context.silence(ida.get());
    return ida;
}

ANCF_INLINE std::string code_name(int code) {
    const std::unique_ptr<char, decltype(&std::free)> name(IDAGetReturnFlagName(code), &std::free);
    return name == nullptr ? std::string() : std::string(name.get());
}

ANCF_INLINE void Context::remember(const char* message) noexcept {
    try {
        message_ = message == nullptr ? "" : message;
    } catch (...) {
        message_.clear();  // no memory for the text: the return code still tells
    }
}

#if SUNDIALS_VERSION_MAJOR >= 7

ANCF_INLINE Context::Context() {
    if (SUNContext_Create(SUN_COMM_NULL, &handle_) != SUN_SUCCESS) throw std::bad_alloc();
    SUNContext_ClearErrHandlers(handle_);
    SUNContext_PushErrHandler(
        handle_,
        [](int, const char*, const char*, const char* message, SUNErrCode, void* self, SUNContext) {
            static_cast<Context*>(self)->remember(message);
        },
        this);
}

ANCF_INLINE void Context::silence(void*) noexcept {
}  // the context's handler serves all its objects

#else

ANCF_INLINE Context::Context() {
    if (SUNContext_Create(nullptr, &handle_) != 0) throw std::bad_alloc();
}

ANCF_INLINE void Context::silence(void* ida) noexcept {
    IDASetErrHandlerFn(
        ida,
        [](int, const char*, const char*, char* message, void* self) {
            static_cast<Context*>(self)->remember(message);
        },
        this);
}

#endif

}  // namespace ancf::sundials
