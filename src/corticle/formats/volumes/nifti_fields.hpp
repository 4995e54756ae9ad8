// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/volumes/nifti_header.hpp"

namespace corticle::formats
{

/// The fields of a header of either kind and byte order.
class NiftiFields
{
  public:
    /// @param start  the first four bytes, taken off the stream already
    /// @throws InputError for what is not a header of NIfTI-1 or -2, or a truncated one
    NiftiFields(std::string_view start, InflatingStream& stream, const std::string& name);

    const std::string& file() const { return name_; }
    const NiftiLayout& layout() const { return layout_; }
    bool big_endian() const { return big_endian_; }
    /// Is this the header of a pair, .hdr and .img?
    bool is_pair() const { return bytes_[layout_.magic + 1] == 'i'; }

    /// Element k of an integer field; 64 bits in NIfTI-2 where `wide`.
    std::int64_t integer(std::size_t offset, std::size_t k = 0) const
    {
        return layout_.wide ? load<std::int64_t>(&bytes_[offset + 8 * k], big_endian_)
                            : load<std::int16_t>(&bytes_[offset + 2 * k], big_endian_);
    }
    double real(std::size_t offset, std::size_t k = 0) const
    {
        return layout_.wide ? load<double>(&bytes_[offset + 8 * k], big_endian_)
                            : static_cast<double>(load<float>(&bytes_[offset + 4 * k], big_endian_));
    }
    std::int64_t code(std::size_t offset) const
    {
        return layout_.wide ? load<std::int32_t>(&bytes_[offset], big_endian_)
                            : load<std::int16_t>(&bytes_[offset], big_endian_);
    }
    std::int64_t datatype() const { return load<std::int16_t>(&bytes_[layout_.datatype], big_endian_); }
    std::int64_t units() const
    {
        return layout_.wide ? load<std::int32_t>(&bytes_[layout_.units], big_endian_)
                            : static_cast<unsigned char>(bytes_[layout_.units]);
    }
    double vox_offset() const
    {
        return layout_.wide ? static_cast<double>(integer(layout_.vox_offset)) : real(layout_.vox_offset);
    }

  private:
    bool find_layout();
    std::string first_bytes() const;
    void require_magic() const;

    const std::string& name_;
    std::array<char, 540> bytes_{};
    NiftiLayout layout_{};
    bool big_endian_ = false;
};

} // namespace corticle::formats
