// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/scatter.hpp"

#include "corticle/mechanics/tlsph/part.hpp"
#include "corticle/model/terms.hpp"

#include <string>

namespace corticle::model
{

namespace
{

template <class Act>
void each_array(material::TissueGrowth& growth, Act&& act)
{
    growth.each_array(act);
}
template <class Act>
void each_array(ElementModel& fem, Act&& act);

/// Sends numbers and arrays of numbers of rank 0 to all others.
class Broadcast
{
  public:
    explicit Broadcast(const Communicator& ranks) : ranks_(ranks) {}

    template <class Number>
    void operator()(Number& number) const
    {
        ranks_.broadcast(std::span(&number, 1));
    }
    template <class Item, class Allocator>
    void operator()(std::vector<Item, Allocator>& items) const
    {
        auto count = static_cast<std::int64_t>(items.size());
        (*this)(count);
        items.resize(static_cast<std::size_t>(count));
        if constexpr (std::is_trivially_copyable_v<Item>)
        {
            ranks_.broadcast(std::span<Item>(items));
        }
        else
        {
            for (Item& item : items)
            {
                (*this)(item);
            }
        }
    }
    template <class Value>
    void operator()(std::optional<Value>& value) const
    {
        bool has_value = value.has_value();
        (*this)(has_value);
        if (has_value)
        {
            each_array(value ? *value : value.emplace(), *this);
        }
    }

  private:
    const Communicator& ranks_;
};

template <class Act>
void each_array(Cloud& cloud, Act&& act)
{
    act(cloud.positions);
    act(cloud.volumes);
    act(cloud.surface_particles);
    act(cloud.surface_triangles);
    act(cloud.spacing);
    act(cloud.local_spacing);
}

template <class Act>
void each_array(TriangleMesh& mesh, Act&& act)
{
    act(mesh.vertices);
    act(mesh.triangles);
}

template <class Act>
void each_array(boundary::TiedSurface& surface, Act&& act)
{
    act(surface.nodes);
    act(surface.weights);
    act(surface.triangles);
}

template <class Act>
void each_array(material::TissueFields& tissue, Act&& act)
{
    act(tissue.volume);
    act(tissue.depth);
    act(tissue.normal);
    act(tissue.mapped_rate);
    act(tissue.regional_rate);
    act(tissue.growth_maps.times);
    act(tissue.growth_maps.values);
    act(tissue.growth_maps.from);
    act(tissue.growth_onset);
    act(tissue.growth_rate);
    act(tissue.region);
    act(tissue.thickness);
    act(tissue.given_theta);
    act(tissue.cortex_inside);
    act(tissue.kind);
    act(tissue.growth);
    act(tissue.fibre);
    act(tissue.given_fibre);
    act(tissue.white_share);
}

template <class Act>
void each_array(tracts::Tracts& all, Act&& act)
{
    act(all.tracts);
    act(all.push);
    act(all.ramp_time);
    auto ends = std::ssize(all.ends);
    act(ends);
    all.ends.resize(static_cast<std::size_t>(ends));
    for (tracts::TractEnd& end : all.ends)
    {
        act(end.nodes);
        act(end.shares);
    }
}

template <class Act>
void each_array(ElementModel& fem, Act&& act)
{
    fem::TetElements& elements = fem.elements;
    act(elements.X);
    act(elements.tets);
    act(elements.volume);
    act(elements.node_volume);
    act(elements.blocks);
    act(elements.chunk_begin);
    act(elements.chunk_node);
    act(elements.part_begin);
    act(elements.part);
    act(elements.spacing);
    each_array(fem.tissue, act);
}

/// Sends every rank its part of the particles that rank 0 has.
void scatter_particles(tlsph::Particles& particles, const Partition& partition, const Communicator& ranks)
{
    const auto bytes_of = [](auto& value)
    {
        if constexpr (requires { value.data(); })
        {
            return std::as_writable_bytes(std::span(value.data(), value.size()));
        }
        else
        {
            return std::as_writable_bytes(std::span(&value, 1));
        }
    };
    const auto send_to = [&](int rank)
    {
        return [&, rank](auto& value)
        {
            if constexpr (requires { value.size(); })
            {
                auto count = static_cast<std::int64_t>(value.size());
                ranks.send(bytes_of(count), rank);
            }
            ranks.send(bytes_of(value), rank);
        };
    };
    const auto receive = [&](auto& value)
    {
        if constexpr (requires { value.size(); })
        {
            std::int64_t count = 0;
            ranks.receive(bytes_of(count));
            value.resize(static_cast<std::size_t>(count));
        }
        ranks.receive(bytes_of(value));
    };
    for (int rank = 1; rank < ranks.size() && ranks.is_root(); ++rank)
    {
        tlsph::Particles part = tlsph::part_of(particles, partition, rank);
        each_array(part, send_to(rank));
    }
    if (ranks.is_root())
    {
        particles = tlsph::part_of(particles, partition, 0);
    }
    else
    {
        each_array(particles, receive);
    }
}

} // namespace

Share scatter(Model& model, const SimulationOptions& options, const Communicator& ranks)
{
    if (ranks.size() == 1)
    {
        return Share(std::ssize(model.cloud.positions));
    }
    const Broadcast to_all(ranks);
    each_array(model.cloud, to_all);
    each_array(model.surface, to_all);
    each_array(model.inner_surface, to_all);
    each_array(model.tissue, to_all);
    to_all(model.fem);
    each_array(model.skull, to_all);
    each_array(model.ventricles, to_all);
    each_array(model.tracts, to_all);
    if (model.fem)
    {
        return Share(std::ssize(model.cloud.positions), ranks);
    }
    tlsph::Particles& particles = model.particles;
    particles.X = model.cloud.positions;
    particles.volume = model.cloud.volumes;
    to_all(particles.spacing);
    to_all(particles.options);
    if (!shares_work(options))
    {
        each_array(particles, to_all);
        return Share(std::ssize(model.cloud.positions), ranks);
    }
    Partition partition;
    if (ranks.is_root())
    {
        partition = make_share(model, options, ranks).partition();
    }
    to_all(partition.first);
    scatter_particles(particles, partition, ranks);
    return {partition, ranks};
}

void broadcast(State& state, const Communicator& ranks)
{
    const Broadcast to_all(ranks);
    to_all(state.motion.x);
    to_all(state.motion.v);
    to_all(state.t);
    to_all(state.steps);
    to_all(state.rejected_steps);
    to_all(state.step_scale);
    to_all(state.loading_rate);
    to_all(state.kinetic_energy);
    to_all(state.energy_balance);
    to_all(state.travel_taken);
    to_all(state.lowest_gi_sphere);
    to_all(state.onset_t);
    auto entries = std::ssize(state.history);
    to_all(entries);
    auto entry = state.history.begin();
    for (std::ptrdiff_t k = 0; k < entries; ++k)
    {
        std::string name = ranks.is_root() ? entry->first : std::string();
        std::vector<char> letters(name.begin(), name.end());
        to_all(letters);
        to_all(ranks.is_root() ? entry++->second : state.history[std::string(letters.begin(), letters.end())]);
    }
}

} // namespace corticle::model
