// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/nifti_header.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace corticle
{

/// Builds a NIfTI file field by field.
class NiftiSample
{
  public:
    NiftiSample(bool wide, bool swapped)
        : layout_(wide ? formats::nifti2_layout : formats::nifti1_layout), swapped_(swapped)
    {
        header_.assign(wide ? 544 : 352, '\0');
        put(0, static_cast<std::int32_t>(layout_.size));
        header_.replace(layout_.magic, wide ? 8 : 4,
                        wide ? std::string("n+2\0\r\n\032\n", 8) : std::string("n+1\0", 4));
        wide ? put(layout_.vox_offset, std::int64_t{544}) : put(layout_.vox_offset, 352.0F);
        for (std::size_t k = 0; k < 8; ++k)
        {
            real(layout_.pixdim, 1.0, k);
        }
    }

    NiftiSample& dimensions(const std::vector<std::int64_t>& sizes)
    {
        integer(layout_.dim, static_cast<std::int64_t>(sizes.size()));
        for (std::size_t k = 0; k < sizes.size(); ++k)
        {
            integer(layout_.dim, sizes[k], k + 1);
        }
        return *this;
    }

    /// A field that has 64 bits in NIfTI-2: dim.
    NiftiSample& integer(std::size_t offset, std::int64_t value, std::size_t k = 0)
    {
        layout_.wide ? put(offset + 8 * k, value) : put(offset + 2 * k, static_cast<std::int16_t>(value));
        return *this;
    }
    NiftiSample& real(std::size_t offset, double value, std::size_t k = 0)
    {
        layout_.wide ? put(offset + 8 * k, value) : put(offset + 4 * k, static_cast<float>(value));
        return *this;
    }
    /// qform_code, sform_code.
    NiftiSample& code(std::size_t offset, int value)
    {
        layout_.wide ? put(offset, std::int32_t{value}) : put(offset, static_cast<std::int16_t>(value));
        return *this;
    }
    NiftiSample& units(int value)
    {
        layout_.wide ? put(layout_.units, std::int32_t{value}) : put(layout_.units, static_cast<char>(value));
        return *this;
    }

    NiftiSample& sform(const imaging::VoxelFrame& frame)
    {
        code(layout_.sform_code, 1);
        for (int row = 0; row < 3; ++row)
        {
            for (int column = 0; column < 4; ++column)
            {
                const double value = column < 3 ? frame.linear(row, column) : frame.origin[row];
                real(layout_.sform, value, static_cast<std::size_t>(4 * row + column));
            }
        }
        return *this;
    }

    template <class Number, class Value>
    NiftiSample& data(formats::NumberType type, const std::vector<Value>& values)
    {
        put(layout_.datatype, static_cast<std::int16_t>(type));
        data_.clear();
        for (const Value value : values)
        {
            data_ += bytes_of_number(static_cast<Number>(value));
        }
        return *this;
    }

    template <class T>
    void put(std::size_t offset, T value)
    {
        const std::string bytes = bytes_of_number(value);
        std::copy(bytes.begin(), bytes.end(), header_.begin() + static_cast<std::ptrdiff_t>(offset));
    }

    const formats::NiftiLayout& layout() const { return layout_; }
    std::string bytes() const { return header_ + data_; }

  private:
    template <class T>
    std::string bytes_of_number(T value) const
    {
        std::string bytes(sizeof(T), '\0');
        std::memcpy(bytes.data(), &value, sizeof(T));
        return swapped_ ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    }

    formats::NiftiLayout layout_;
    bool swapped_;
    std::string header_;
    std::string data_;
};

/// Labels 0 to 6 of a 4 x 3 x 2 image.
inline std::vector<std::int32_t> sample_labels()
{
    std::vector<std::int32_t> labels;
    for (int k = 0; k < 24; ++k)
    {
        labels.push_back(k * 5 % 7);
    }
    return labels;
}

/// A valid file of 8-bit labels.
inline NiftiSample plain_sample(bool wide = false, bool swapped = false)
{
    NiftiSample sample(wide, swapped);
    sample.dimensions({4, 3, 2}).data<std::uint8_t>(formats::NumberType::uint8, sample_labels());
    return sample;
}

} // namespace corticle
