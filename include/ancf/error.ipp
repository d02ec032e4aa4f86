// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>

#include <ostream>
#include <sstream>

namespace ancf::detail {

ANCF_INLINE void MessagePart::write(std::ostream& out) const {
    switch (kind_) {
        case Kind::text: out << text_; break;
        case Kind::letter: out << letter_; break;
        case Kind::real: out << real_; break;
        case Kind::integer: out << std::to_string(integer_); break;
        case Kind::natural: out << std::to_string(natural_); break;
        case Kind::row:
            for (std::ptrdiff_t k = 0; k < row_.count; ++k)
                out << (k > 0 ? " " : "") << row_.values[k];
    }
}

ANCF_INLINE std::string joined(std::initializer_list<MessagePart> parts, int digits) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(digits);
    for (const MessagePart& part : parts) part.write(stream);
    return stream.str();
}

ANCF_INLINE void reject_parts(std::initializer_list<MessagePart> parts) {
    throw InvalidArgument(joined(parts, 17));
}

ANCF_INLINE void require_finite(std::string_view name, const Components& row) {
    for (std::ptrdiff_t k = 0; k < row.count; ++k)
        require(std::isfinite(row.values[k]), name, " must be finite, got ", row);
}

}  // namespace ancf::detail
