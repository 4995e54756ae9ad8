// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/volumes/volume_header.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace corticle::formats
{

/// The bytes of an image of one file, or of a pair; each may be gzip-compressed.
struct VolumeBytes
{
    std::string_view header;
    std::string_view image; ///< of a pair; else empty
};

/// Is this, by its name in either case, an image: NIfTI (.nii, or .hdr and .img) or MGH (.mgh, .mgz), each also with
/// .gz behind it?
bool is_volume(const std::filesystem::path& file);

/// The file or files of an image, in memory.
class VolumeFile
{
  public:
    /// @throws InputError, one line, when they cannot be read
    explicit VolumeFile(const std::filesystem::path& file);
    VolumeBytes bytes() const { return {header_, image_}; }

  private:
    std::string header_;
    std::string image_;
};

/// Header and numbers of an image. The numbers are taken off piece by piece, so an image that announces more than it
/// holds takes no memory.
class VolumeNumbers
{
  public:
    /// @param bytes  must outlive this
    /// @throws InputError, one line naming the file, for what is no image, or announces more than its bytes can hold
    VolumeNumbers(const VolumeBytes& bytes, const std::string& name, Coordinates coordinates);

    const VolumeHeader& header() const { return header_; }

    /// Receives numbers, scaled as the header says, and the index of the first of them among all that are asked for.
    using Take = std::function<void(std::span<const double> numbers, std::size_t first)>;
    /// The numbers of `count` volumes from one on, x fastest. May be called once. @throws InputError for a short file
    void read(std::int64_t volume, std::int64_t count, const Take& take);

  private:
    std::size_t read_piece(std::size_t bytes);
    void skip(std::size_t bytes);

    std::string name_;
    InflatingStream stream_;
    std::optional<InflatingStream> image_; ///< of a pair
    VolumeHeader header_;
    std::string piece_;
};

/// Which volume of several: the one asked for, or the only one. @throws InputError
std::int64_t chosen_volume(const VolumeHeader& header, std::optional<std::int64_t> volume, const std::string& name);

/// Refuses an image that takes more than the memory of this machine. @throws InputError
void require_memory(const VolumeHeader& header, std::size_t bytes_per_voxel, const std::string& name);

} // namespace corticle::formats
