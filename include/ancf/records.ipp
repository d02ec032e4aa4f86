// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/records.hpp>

#include <cstring>
#include <new>

namespace ancf::detail {

ANCF_INLINE void RecordStorage::make_room(std::size_t records, std::size_t record) {
    const std::size_t capacity = records > 2 * capacity_ ? records : 2 * capacity_;
    void* const data = alignment_ > __STDCPP_DEFAULT_NEW_ALIGNMENT__
                           ? ::operator new(capacity* record, std::align_val_t(alignment_))
                           : ::operator new(capacity* record);
    if (size_ > 0) std::memcpy(data, data_, size_ * record);
    release();
    data_ = data;
    capacity_ = capacity;
}

ANCF_INLINE void RecordStorage::copy(const RecordStorage& other, std::size_t record) {
    size_ = 0;
    if (other.size_ > capacity_) make_room(other.size_, record);
    if (other.size_ > 0) std::memcpy(data_, other.data_, other.size_ * record);
    size_ = other.size_;
}

ANCF_INLINE void RecordStorage::release() noexcept {
    if (alignment_ > __STDCPP_DEFAULT_NEW_ALIGNMENT__)
        ::operator delete(data_, std::align_val_t(alignment_));
    else
        ::operator delete(data_);
}

}  // namespace ancf::detail
