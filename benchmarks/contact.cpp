// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/counters.hpp"
#include "benchmarks/folds.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"

namespace corticle::bench
{
namespace
{

void report(benchmark::State& state, const FoldedSphere& surface, double candidates)
{
    count_particles(state, static_cast<double>(state.range(0)));
    state.counters["ns_per_pair"] = time_each(candidates, 1e9);
    state.counters["vertices"] = static_cast<double>(surface.x.size());
    state.counters["candidates"] = candidates;
}

double count(const contact::Candidates& candidates)
{
    return static_cast<double>(candidates.vertex_triangle.size() + candidates.edge_edge.size());
}

/// Pairs of a fully folded surface as SurfaceContact with its default options asks for them where vertices move at
/// 0.004 spacings a step.
double find_candidates(const FoldedSphere& surface, contact::SurfaceParts& parts)
{
    constexpr double dhat = 0.3;  // [spacings]
    constexpr double reach = 0.2; // [spacings]
    contact::Candidates found;
    parts.find_candidates(surface.x, dhat, std::vector(surface.x.size(), reach), {}, found);
    return count(found);
}

/// The search, which a run makes once in some twenty steps.
void contact_detection(benchmark::State& state)
{
    const FoldedSphere& surface = made_for<FoldedSphere>(state.range(0));
    contact::SurfaceParts parts(surface.rest.triangles, surface.rest.vertices);
    double candidates = 0.0;
    for (auto _ : state)
    {
        candidates = find_candidates(surface, parts);
    }
    report(state, surface, candidates);
}

constexpr double usual_way = 0.025; ///< of the fastest vertex in a step of a folding sphere [spacings]

/// Distances and forces of the pairs at hand. The surface goes to and fro, since pairs are not measured
/// again before something has moved.
void contact_force(benchmark::State& state)
{
    const FoldedSphere& surface = made_for<FoldedSphere>(state.range(0));
    contact::SurfaceContact contact(surface.rest.triangles, surface.rest.vertices,
                                    std::vector<double>(surface.x.size(), 0.5), 1.0, 2.5, {});
    std::vector<Vec3> forces(surface.x.size());
    std::vector<Vec3> moved = surface.x;
    for (Vec3& x : moved)
    {
        x.x += usual_way;
    }
    bool there = false;
    const auto evaluate = [&]
    {
        there = !there;
        return contact.evaluate(there ? moved : surface.x, forces);
    };
    if (evaluate().active == 0)
    {
        state.SkipWithError("no banks in touch");
    }
    std::int64_t active = 0;
    for (auto _ : state)
    {
        std::fill(forces.begin(), forces.end(), Vec3{});
        active = evaluate().active;
    }
    contact::SurfaceParts parts(surface.rest.triangles, surface.rest.vertices);
    report(state, surface, find_candidates(surface, parts));
    state.counters["active"] = static_cast<double>(active);
}

const bool registered = register_by_size({{"contact_detection", contact_detection}, {"contact_force", contact_force}});

} // namespace
} // namespace corticle::bench
