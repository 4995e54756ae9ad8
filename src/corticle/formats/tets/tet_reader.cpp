// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/tets/tet_reader.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/plain_file.hpp"
#include "corticle/formats/tets/tet_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace corticle::formats
{

namespace
{

/// From tags to indices. Most files count nodes up from 0 or 1; others take a search.
class TagIndex
{
  public:
    explicit TagIndex(std::span<const std::int64_t> tags) : count_(std::ssize(tags)), first_(tags.empty() ? 0 : tags[0])
    {
        bool counts_up = true;
        for (std::size_t i = 0; i < tags.size(); ++i)
        {
            // Unsigned: the tags of a damaged file may lie anywhere.
            counts_up = counts_up && static_cast<std::uint64_t>(tags[i]) - static_cast<std::uint64_t>(first_) == i;
        }
        if (!counts_up)
        {
            for (std::size_t i = 0; i < tags.size(); ++i)
            {
                sorted_.emplace_back(tags[i], static_cast<std::int32_t>(i));
            }
            std::sort(sorted_.begin(), sorted_.end());
        }
    }

    /// A tag that was given twice.
    std::optional<std::int64_t> repeated() const
    {
        const auto found = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                              [](const auto& a, const auto& b) { return a.first == b.first; });
        return found == sorted_.end() ? std::nullopt : std::optional(found->first);
    }

    /// Index of the node of a tag, -1 where there is none.
    std::int32_t find(std::int64_t tag) const
    {
        if (sorted_.empty())
        {
            const std::uint64_t steps = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(first_);
            return steps < static_cast<std::uint64_t>(count_) ? static_cast<std::int32_t>(steps) : -1;
        }
        const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(tag, std::int32_t{0}));
        return found != sorted_.end() && found->first == tag ? found->second : -1;
    }

  private:
    std::int64_t count_;
    std::int64_t first_;
    std::vector<std::pair<std::int64_t, std::int32_t>> sorted_; ///< empty when tags count up
};

} // namespace

void TetBuilder::reserve_nodes(std::size_t nodes)
{
    tags_.reserve(nodes);
    positions_.reserve(nodes);
}

void TetBuilder::add_node(std::int64_t tag, const Vec3& position)
{
    if (!is_finite(position))
    {
        fail_reading(file_, fmt::format("node {} is not finite", tag),
                     fmt::format("({}, {}, {})", position.x, position.y, position.z), "finite coordinates");
    }
    if (node_count() >= std::numeric_limits<std::int32_t>::max())
    {
        fail_reading(file_, "too many nodes", "more than 2147483647", "fewer");
    }
    tags_.push_back(tag);
    positions_.push_back(position);
}

void TetBuilder::add_tet(std::span<const std::int64_t> tags)
{
    if (tet_count() >= std::numeric_limits<std::int32_t>::max() / 4)
    {
        fail_reading(file_, "too many tets", "more than 536870911", "fewer");
    }
    higher_order_ += tags.size() > 4 ? 1 : 0;
    tets_.push_back({tags[0], tags[1], tags[2], tags[3]});
}

TetMesh TetBuilder::finish(std::vector<std::string>* notes)
{
    if (tets_.empty())
    {
        fail_reading(file_, "no tets in the file", "0 tets", "at least one");
    }
    const TagIndex index(tags_);
    if (const auto tag = index.repeated())
    {
        fail_reading(file_, "two nodes of one number", fmt::format("{} twice", *tag), "a number of its own for each");
    }
    TetMesh mesh;
    mesh.tets.resize(tets_.size());
    for (std::size_t i = 0; i < tets_.size(); ++i)
    {
        for (std::size_t k = 0; k < 4; ++k)
        {
            mesh.tets[i][k] = index.find(tets_[i][k]);
            if (mesh.tets[i][k] < 0)
            {
                fail_reading(file_, fmt::format("tet {} (counted from 0) names no node", i),
                             fmt::format("node {}", tets_[i][k]), "the number of a node of the file");
            }
        }
    }
    mesh.vertices = std::move(positions_);
    if (higher_order_ > 0 && notes != nullptr)
    {
        notes->push_back(fmt::format("{} tets of second or higher order: only their corners are used", higher_order_));
    }
    return mesh;
}

bool is_tet_file(const std::filesystem::path& file)
{
    const std::string extension = plain_extension(file);
    return extension == "msh" || extension == "mesh" || extension == "vtu" ||
           (extension == "vtk" && has_legacy_vtk_tets(read_plain_file(file).bytes, file.string()));
}

TetMesh parse_tets(std::string_view bytes, const std::string& name, std::vector<std::string>* notes)
{
    bytes = without_byte_order_mark(bytes);
    std::string_view rest = bytes;
    std::string_view first = take_word(rest);
    if (bytes.starts_with("# vtk"))
    {
        TetBuilder mesh(name);
        parse_legacy_vtk_tets(bytes, mesh);
        return mesh.finish(notes);
    }
    while (!first.empty() && first.front() == '#')
    {
        take_line(rest, first);
        first = take_word(rest);
    }
    TetBuilder mesh(name);
    std::int64_t number = 0;
    if (first.starts_with('$'))
    {
        parse_gmsh(bytes, mesh);
    }
    else if (first.starts_with('<'))
    {
        parse_vtu(bytes, mesh);
    }
    else if (first.starts_with("MeshVersionFormatted"))
    {
        parse_medit(bytes, mesh);
    }
    else if (to_number(first, number))
    {
        parse_netgen(bytes, mesh);
    }
    else
    {
        fail_reading(name, "unknown kind of tet mesh", first.empty() ? "an empty file" : first,
                     "Gmsh .msh, VTK .vtu or .vtk, Netgen neutral or Medit .mesh");
    }
    return mesh.finish(notes);
}

TetMesh read_tets(const std::filesystem::path& file, double scale, std::vector<std::string>* notes)
{
    const std::string name = file.string();
    TetMesh mesh = parse_tets(read_plain_file(file).bytes, name, notes);
    for (Vec3& vertex : mesh.vertices)
    {
        vertex *= scale;
        if (!is_finite(vertex))
        {
            fail_reading(name, "a node is not finite once scaled", fmt::format("scale {}", scale),
                         "finite coordinates");
        }
    }
    return mesh;
}

} // namespace corticle::formats
