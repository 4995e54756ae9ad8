// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/fibres.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/vector_volume.hpp"

#include <fmt/format.h>

namespace corticle::prepare
{

namespace
{

/// What is neither cortex at the start nor labelled as another tissue.
std::vector<double> white_share(const PreparationOptions& options, const material::TissueFields& tissue)
{
    std::vector<double> share =
        material::start_tissue(tissue, options.tissue, model::cortex_size(options), options.time.start).theta;
    for (std::size_t i = 0; i < share.size(); ++i)
    {
        const bool is_white = tissue.kind.empty() || tissue.kind[i] == material::TissueKind::white;
        share[i] = is_white ? 1.0 - share[i] : 0.0;
    }
    return share;
}

Vec3 centroid_of(const Cloud& body)
{
    Vec3 sum;
    double volume = 0.0;
    for (std::size_t i = 0; i < body.positions.size(); ++i)
    {
        sum += body.volumes[i] * body.positions[i];
        volume += body.volumes[i];
    }
    return (1.0 / volume) * sum;
}

/// Away from the centroid; there, where no direction is, along x.
Vec3 radial_direction(const Vec3& from_centroid)
{
    const double distance = norm(from_centroid);
    return distance > 0.0 ? (1.0 / distance) * from_centroid : Vec3{1.0, 0.0, 0.0};
}

/// Of a vector of any length; where it has none there are no fibres, which is told by the share of white matter.
void set_fibre(const Vec3& vector, double& white_share, Vec3& fibre)
{
    const double length = norm(vector);
    white_share = length > 0.0 ? white_share : 0.0;
    fibre = length > 0.0 ? (1.0 / length) * vector : Vec3{1.0, 0.0, 0.0};
}

/// Of the voxel that each place lies in; where it has no vector, or there is no voxel, there are no fibres.
void set_fibres_of_file(const std::string& file, std::span<const Vec3> places, material::TissueFields& tissue)
{
    const formats::VectorVolume volume = formats::read_vectors(file);
    const Mat3 to_index = inverse(volume.frame.linear);
    std::size_t found = 0;
    tissue.fibre.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const Vec3* const vector = volume.at(to_index * (places[i] - volume.frame.origin));
        const Vec3 there = vector != nullptr ? *vector : Vec3{};
        set_fibre(there, tissue.white_share[i], tissue.fibre[i]);
        found += norm(there) > 0.0 ? 1 : 0;
    }
    if (found == 0)
    {
        throw InputError(
            fmt::format("fibres.file {}: holds no vector at any of {} points of the body; expected some in "
                        "the coordinates of the body",
                        file, places.size()));
    }
}

} // namespace

void set_fibres(const PreparationOptions& options, const Cloud& body, std::span<const Vec3> places,
                material::TissueFields& tissue)
{
    const material::RemodellingOptions& remodelling = options.tissue.remodelling;
    tissue.fibre.clear();
    tissue.white_share.clear();
    if (remodelling.has_fibres() || remodelling.stress_growth.rate > 0.0)
    {
        tissue.white_share = white_share(options, tissue);
    }
    if (remodelling.has_fibres() && !tissue.given_fibre.empty())
    {
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            set_fibre(tissue.given_fibre[i], tissue.white_share[i], tissue.fibre.emplace_back());
        }
        return;
    }
    if (remodelling.fibres.direction == material::FibreField::radial)
    {
        const Vec3 centroid = centroid_of(body);
        for (const Vec3& place : places)
        {
            tissue.fibre.push_back(radial_direction(place - centroid));
        }
    }
    if (remodelling.fibres.direction == material::FibreField::depth)
    {
        tissue.fibre = tissue.normal; // the gradient of the distance to the surface, whose sign does not matter
    }
    if (remodelling.fibres.direction == material::FibreField::file)
    {
        set_fibres_of_file(options.fibre_file, places, tissue);
    }
}

} // namespace corticle::prepare
