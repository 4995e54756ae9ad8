// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/anatomy.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/toml_document.hpp"
#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace corticle::view
{

namespace
{

constexpr Vec3 left{-1, 0, 0};
constexpr Vec3 right{1, 0, 0};
constexpr Vec3 front{0, 1, 0};
constexpr Vec3 back{0, -1, 0};
constexpr Vec3 above{0, 0, 1};
constexpr Vec3 below{0, 0, -1};
constexpr Vec3 oblique{-0.621743, 0.601687, 0.501406};
constexpr Vec3 oblique_up{0.360311, -0.348688, 0.865212};

constexpr std::array views{
    AnatomicalView{"left-lateral", left, above, -1, "left, lateral", "−x half, from −x"},
    AnatomicalView{"left-medial", right, above, -1, "left, medial", "−x half, from +x"},
    AnatomicalView{"right-medial", left, above, 1, "right, medial", "+x half, from −x"},
    AnatomicalView{"right-lateral", right, above, 1, "right, lateral", "+x half, from +x"},
    AnatomicalView{"left-dorsal", above, front, -1, "left, dorsal", "−x half, from +z"},
    AnatomicalView{"left-ventral", below, front, -1, "left, ventral", "−x half, from −z"},
    AnatomicalView{"right-ventral", below, front, 1, "right, ventral", "+x half, from −z"},
    AnatomicalView{"right-dorsal", above, front, 1, "right, dorsal", "+x half, from +z"},
    AnatomicalView{"left", left, above, 0, "left", "from −x"},
    AnatomicalView{"right", right, above, 0, "right", "from +x"},
    AnatomicalView{"dorsal", above, front, 0, "dorsal", "from +z"},
    AnatomicalView{"ventral", below, front, 0, "ventral", "from −z"},
    AnatomicalView{"anterior", front, above, 0, "anterior", "from +y"},
    AnatomicalView{"posterior", back, above, 0, "posterior", "from −y"},
    AnatomicalView{"oblique", oblique, oblique_up, 0, "oblique", "oblique"},
};

std::string mark_of(const Vec3& direction, bool is_brain)
{
    constexpr double least = 0.35; // of a direction, to be told
    constexpr std::array<std::array<std::string_view, 2>, 3> letters{{{"L", "R"}, {"P", "A"}, {"I", "S"}}};
    constexpr std::array<std::array<std::string_view, 2>, 3> axes{{{"−x", "+x"}, {"−y", "+y"}, {"−z", "+z"}}};
    std::vector<int> order{0, 1, 2};
    std::erase_if(order, [&](int axis) { return std::abs(direction[axis]) < least; });
    std::ranges::sort(order, [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
    std::string mark;
    for (const int axis : order)
    {
        const auto& names = (is_brain ? letters : axes)[static_cast<std::size_t>(axis)];
        mark += mark.empty() || is_brain ? "" : " ";
        mark += names[direction[axis] > 0.0 ? 1 : 0];
    }
    return mark;
}

} // namespace

std::span<const AnatomicalView> anatomical_views()
{
    return views;
}

std::vector<AnatomicalView> views_named(std::span<const std::string> names)
{
    std::vector<AnatomicalView> chosen;
    for (const std::string& name : names)
    {
        const auto found = std::ranges::find(views, name, &AnatomicalView::name);
        if (found == views.end())
        {
            std::vector<std::string_view> known;
            std::ranges::transform(views, std::back_inserter(known), &AnatomicalView::name);
            throw InputError(fmt::format("--view: got \"{}\"; expected one of {}", name, fmt::join(known, ", ")));
        }
        chosen.push_back(*found);
    }
    return chosen;
}

std::vector<AnatomicalView> usual_views(imaging::Hemisphere part)
{
    const int other = part == imaging::Hemisphere::left ? 1 : part == imaging::Hemisphere::right ? -1 : 0;
    std::vector<AnatomicalView> chosen;
    std::ranges::copy_if(views, std::back_inserter(chosen),
                         [&](const AnatomicalView& view) { return view.half != 0 && view.half != other; });
    return chosen;
}

std::array<std::string, 2> side_marks(const AnatomicalView& view, bool is_brain)
{
    return {mark_of(-view.right(), is_brain), mark_of(view.right(), is_brain)};
}

BodySides body_sides(const std::filesystem::path& run_folder)
{
    BodySides sides;
    const std::filesystem::path file = run_folder / "case.toml";
    std::error_code error;
    if (!std::filesystem::exists(file, error))
    {
        return sides;
    }
    for (const config::TomlEntry& entry : config::parse_toml(formats::read_whole_file(file), file.string()))
    {
        const auto* text = std::get_if<std::string>(&entry.value);
        if (text != nullptr && entry.key == "geometry.shape")
        {
            sides.is_brain = *text == "file";
        }
        else if (text != nullptr && entry.key == "geometry.hemisphere")
        {
            const auto name = std::ranges::find(imaging::hemisphere_names, *text);
            sides.part = name == imaging::hemisphere_names.end()
                             ? imaging::Hemisphere::both
                             : static_cast<imaging::Hemisphere>(name - imaging::hemisphere_names.begin());
        }
    }
    return sides;
}

} // namespace corticle::view
