// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace corticle::geometry
{

// What this library and the program corticle-tetrahedralize say to each other, in the byte order of the machine: a
// word that names the content, then arrays, each as its number of elements and the elements.

/// Exit statuses of the program.
enum class TetStatus
{
    done = 0,
    not_filled = 1, ///< Gmsh cannot fill the surface
    out_of_memory = 2,
    not_understood = 3 ///< the input is not a request
};

/// A closed surface to fill with tets of about this size.
struct TetRequest
{
    static constexpr std::string_view name = "surf 1\n";
    std::vector<double> size;          ///< one number [mm]
    std::vector<double> coordinates;   ///< three of each vertex [mm]
    std::vector<std::int32_t> corners; ///< three of each triangle
};

/// The nodes, those of the surface first, and the tets.
struct TetAnswer
{
    static constexpr std::string_view name = "tets 1\n";
    std::vector<double> coordinates;   ///< three of each node [mm]
    std::vector<std::int32_t> corners; ///< four of each tet
};

template <class T>
void append(std::string& bytes, const std::vector<T>& values)
{
    const std::uint64_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

/// False where `bytes` hold less than they say.
template <class T>
bool take(std::string_view& bytes, std::vector<T>& values)
{
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count)
    {
        return false;
    }
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(T))
    {
        return false;
    }
    values.resize(count);
    std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return true;
}

/// False where `corners` name what is not there.
inline bool names_nodes(const std::vector<std::int32_t>& corners, const std::vector<double>& coordinates)
{
    const auto nodes = static_cast<std::int32_t>(coordinates.size() / 3);
    for (const std::int32_t corner : corners)
    {
        if (corner < 0 || corner >= nodes)
        {
            return false;
        }
    }
    return true;
}

inline std::string to_bytes(const TetRequest& request)
{
    std::string bytes(TetRequest::name);
    append(bytes, request.size);
    append(bytes, request.coordinates);
    append(bytes, request.corners);
    return bytes;
}

inline std::string to_bytes(const TetAnswer& answer)
{
    std::string bytes(TetAnswer::name);
    append(bytes, answer.coordinates);
    append(bytes, answer.corners);
    return bytes;
}

/// Nothing where the bytes are not a request.
inline std::optional<TetRequest> read_request(std::string_view bytes)
{
    TetRequest request;
    const bool is_named = bytes.starts_with(TetRequest::name);
    bytes.remove_prefix(is_named ? TetRequest::name.size() : 0);
    const bool is_whole = is_named && take(bytes, request.size) && take(bytes, request.coordinates) &&
                          take(bytes, request.corners) && bytes.empty();
    const bool is_sound = is_whole && request.size.size() == 1 && request.coordinates.size() % 3 == 0 &&
                          request.corners.size() % 3 == 0 && names_nodes(request.corners, request.coordinates);
    return is_sound ? std::optional(std::move(request)) : std::nullopt;
}

/// Nothing where the bytes are not an answer.
inline std::optional<TetAnswer> read_answer(std::string_view bytes)
{
    TetAnswer answer;
    const bool is_named = bytes.starts_with(TetAnswer::name);
    bytes.remove_prefix(is_named ? TetAnswer::name.size() : 0);
    const bool is_whole = is_named && take(bytes, answer.coordinates) && take(bytes, answer.corners) && bytes.empty();
    const bool is_sound = is_whole && answer.coordinates.size() % 3 == 0 && answer.corners.size() % 4 == 0 &&
                          names_nodes(answer.corners, answer.coordinates);
    return is_sound ? std::optional(std::move(answer)) : std::nullopt;
}

} // namespace corticle::geometry
