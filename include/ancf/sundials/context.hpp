// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Owners of the objects of SUNDIALS, and the one place that knows versions 6 and 7 apart.
///
/// A context is silent: what SUNDIALS would print is kept as text. Each owner frees its object on
/// every path; a context is declared before the objects that were made in it.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_types.h>

#include <cstddef>
#include <limits>
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

    /// Keeps a message, as one of SUNDIALS.
    void remember(const char* message) noexcept;
#if SUNDIALS_VERSION_MAJOR < 7
    /// Keeps a message for the context that it is given to; a handler of SUNDIALS.
    static void take(int, const char*, const char*, char* message, void* context) noexcept {
        static_cast<Context*>(context)->remember(message);
    }
#endif

private:
    SUNContext handle_ = nullptr;
    std::string message_;
};

namespace detail {

/// Returns a count as an index of SUNDIALS, whose `sunindextype` has 32 or 64 bits.
/// @tparam Index  signed.
/// @param what    what is counted, for the message.
/// @throws InvalidArgument where the type cannot hold the count.
template <class Index = sunindextype>
[[nodiscard]] Index checked_index(std::ptrdiff_t count, const char* what) {
    constexpr auto most = std::numeric_limits<Index>::max();
    if (count > most)
        ancf::detail::reject_parts({count, " ", what, "; this build of SUNDIALS counts them by ",
                                    static_cast<int>(8 * sizeof(Index)), " bits and takes at most ",
                                    most});
    return static_cast<Index>(count);
}

/// Passes a new object on, or throws where SUNDIALS returned none.
template <class Handle>
Handle made(Handle handle) {
    if (handle == nullptr) throw std::bad_alloc();
    return handle;
}

/// Frees an object by a function that takes its handle, or the address of that.
template <auto Free>
struct Destroy {
    template <class Handle>
    void operator()(Handle handle) const noexcept {
        if constexpr (std::is_same_v<Handle, void*>)
            Free(&handle);
        else
            Free(handle);
    }
};

}  // namespace detail

/// Owns an N_Vector.
using VectorOwner = std::unique_ptr<std::remove_pointer_t<N_Vector>, detail::Destroy<N_VDestroy>>;
/// Owns a SUNMatrix.
using MatrixOwner =
    std::unique_ptr<std::remove_pointer_t<SUNMatrix>, detail::Destroy<SUNMatDestroy>>;
/// Owns a SUNLinearSolver.
using LinearSolverOwner =
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, detail::Destroy<SUNLinSolFree>>;
/// Owns Newton's method of SUNDIALS.
using NewtonOwner =
    std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, detail::Destroy<SUNNonlinSolFree>>;
using IdaOwner = std::unique_ptr<void, detail::Destroy<IDAFree>>;  ///< owns the memory of IDA

/// Returns a vector of zeros.
/// @throws InvalidArgument where SUNDIALS cannot count so far: see checked_index
[[nodiscard]] VectorOwner make_vector(const Context& context, Eigen::Index size);

/// Returns an empty sparse matrix in compressed columns.
/// @throws InvalidArgument where SUNDIALS cannot count so far: see checked_index
[[nodiscard]] MatrixOwner make_matrix(const Context& context, Eigen::Index size,
                                      Eigen::Index values);

/// Returns the entries of a vector of SUNDIALS as a column that can be read and written.
[[nodiscard]] inline Eigen::Map<VectorX> view(N_Vector vector) noexcept {
    return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

}  // namespace ancf::sundials

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/context.ipp>  // IWYU pragma: export
#endif
