// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Owners of the objects of SUNDIALS, and the one place that knows versions 6 and 7 apart.
///
/// A context is silent: what SUNDIALS would print is kept as text. Each owner frees its object on
/// every path; a context is declared before the objects that were made in it.

#pragma once

#include <ancf/sundials/index.hpp>
#include <ancf/types.hpp>

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_types.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

#if !defined(SUNDIALS_VERSION_MAJOR) || SUNDIALS_VERSION_MAJOR < 6
#error "ancf::sundials needs SUNDIALS 6 or newer"
#endif

namespace ancf::sundials {

static_assert(std::is_same_v<sunrealtype, double>,
              "ancf::sundials needs SUNDIALS in double precision");

/// A SUNContext that prints nothing and keeps the last message instead.
class Context {
public:
    /// @throws std::bad_alloc where SUNDIALS cannot make one.
    Context();
    ~Context() { SUNContext_Free(&handle_); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Returns the context of the C library.
    [[nodiscard]] SUNContext get() const noexcept { return handle_; }

    /// Returns what SUNDIALS said last, empty if nothing.
    [[nodiscard]] const std::string& message() const noexcept { return message_; }

    /// Forgets it.
    void forget_message() noexcept { message_.clear(); }

    /// Turns the messages of an IDA object to this context.
    void silence(void* ida) noexcept;

    /// Keeps a message, as one of SUNDIALS.
    void remember(const char* message) noexcept;

private:
    SUNContext handle_ = nullptr;
    std::string message_;
};

namespace detail {

struct DestroyVector {
    void operator()(N_Vector vector) const noexcept { N_VDestroy(vector); }
};
struct DestroyMatrix {
    void operator()(SUNMatrix matrix) const noexcept { SUNMatDestroy(matrix); }
};
struct DestroyLinearSolver {
    void operator()(SUNLinearSolver solver) const noexcept { SUNLinSolFree(solver); }
};
struct DestroyIda {
    void operator()(void* ida) const noexcept { IDAFree(&ida); }
};

/// Passes a new object on, or throws where SUNDIALS returned none.
template <class Handle>
Handle made(Handle handle) {
    if (handle == nullptr) throw std::bad_alloc();
    return handle;
}

}  // namespace detail

/// Owns an N_Vector.
using VectorOwner = std::unique_ptr<std::remove_pointer_t<N_Vector>, detail::DestroyVector>;
/// Owns a SUNMatrix.
using MatrixOwner = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, detail::DestroyMatrix>;
/// Owns a SUNLinearSolver.
using LinearSolverOwner =
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, detail::DestroyLinearSolver>;
using IdaOwner = std::unique_ptr<void, detail::DestroyIda>;  ///< owns the memory of IDA

/// Returns a vector of zeros.
/// @throws InvalidArgument where SUNDIALS cannot count so far: see checked_index
[[nodiscard]] inline VectorOwner make_vector(const Context& context, Eigen::Index size) {
    const auto length = detail::checked_index(size, "unknowns");
    VectorOwner vector(detail::made(N_VNew_Serial(length, context.get())));
    N_VConst(0.0, vector.get());
    return vector;
}

/// Returns an empty sparse matrix in compressed columns.
/// @throws InvalidArgument where SUNDIALS cannot count so far: see checked_index
[[nodiscard]] inline MatrixOwner make_matrix(const Context& context, Eigen::Index size,
                                             Eigen::Index values) {
    const auto length = detail::checked_index(size, "unknowns");
    const auto entries = detail::checked_index(values, "entries of the Jacobian");
    return MatrixOwner(
        detail::made(SUNSparseMatrix(length, length, entries, CSC_MAT, context.get())));
}

/// Returns KLU for the size of a matrix and a vector.
[[nodiscard]] inline LinearSolverOwner make_klu(const Context& context, N_Vector vector,
                                                SUNMatrix matrix) {
    return LinearSolverOwner(detail::made(SUNLinSol_KLU(vector, matrix, context.get())));
}

/// Returns an IDA object whose messages go to the context.
[[nodiscard]] inline IdaOwner make_ida(Context& context) {
    IdaOwner ida(detail::made(IDACreate(context.get())));
    context.silence(ida.get());
    return ida;
}

/// Returns IDA's own name of a return code, such as IDA_ERR_FAIL.
[[nodiscard]] inline std::string code_name(int code) {
    const std::unique_ptr<char, decltype(&std::free)> name(IDAGetReturnFlagName(code), &std::free);
    return name == nullptr ? std::string() : std::string(name.get());
}

/// Returns the entries of a vector of SUNDIALS as a column that can be read and written.
[[nodiscard]] inline Eigen::Map<VectorX> view(N_Vector vector) noexcept {
    return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

inline void Context::remember(const char* message) noexcept {
    try {
        message_ = message == nullptr ? "" : message;
    } catch (...) {
        message_.clear();  // no memory for the text: the return code still tells
    }
}

#if SUNDIALS_VERSION_MAJOR >= 7

inline Context::Context() {
    if (SUNContext_Create(SUN_COMM_NULL, &handle_) != SUN_SUCCESS) throw std::bad_alloc();
    SUNContext_ClearErrHandlers(handle_);
    SUNContext_PushErrHandler(
        handle_,
        [](int, const char*, const char*, const char* message, SUNErrCode, void* self, SUNContext) {
            static_cast<Context*>(self)->remember(message);
        },
        this);
}

inline void Context::silence(void*) noexcept {}  // the context's handler serves all its objects

#else

inline Context::Context() {
    if (SUNContext_Create(nullptr, &handle_) != 0) throw std::bad_alloc();
}

inline void Context::silence(void* ida) noexcept {
    IDASetErrHandlerFn(
        ida,
        [](int, const char*, const char*, char* message, void* self) {
            static_cast<Context*>(self)->remember(message);
        },
        this);
}

#endif

}  // namespace ancf::sundials
