// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/folds.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

// Times what a rank does of the contact of a sphere, smooth and fully folded, for several numbers of ranks: each in turn,
// by this process alone, as if what the others send were there at once.

namespace
{

using namespace corticle;

constexpr double usual_way = 0.025;      // of the fastest vertex in a step [spacings]
constexpr double steps_of_a_search = 30; // candidates last so many steps, about
constexpr int most_ranks_timed = 8;
constexpr int repetitions = 10;

/// A rank whose others say nothing.
class Pretended final : public Communicator
{
  public:
    Pretended(int rank, int size) : rank_(rank), size_(size) {}
    int rank() const override { return rank_; }
    int size() const override { return size_; }

  private:
    int rank_;
    int size_;
};

/// The surface, its vertices along a curve, as those of a body are.
struct Surface
{
    Surface(std::int64_t particles, bool is_folded)
    {
        const bench::FoldedSphere folded(particles);
        std::vector<std::int32_t> place(folded.x.size());
        for (const std::int32_t k : hilbert_order(folded.rest.vertices))
        {
            place[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(x.size());
            rest.push_back(folded.rest.vertices[static_cast<std::size_t>(k)]);
            x.push_back(is_folded ? folded.x[static_cast<std::size_t>(k)] : rest.back());
        }
        for (const auto& [a, b, c] : folded.rest.triangles)
        {
            triangles.push_back({place[a], place[b], place[c]});
        }
    }

    std::vector<Triangle> triangles;
    std::vector<Vec3> rest;
    std::vector<Vec3> x;
};

/// Seconds of an evaluation where all vertices go to and fro by a way.
double seconds_of(contact::SurfaceContact& contact, const Surface& surface, double way)
{
    std::vector<Vec3> moved = surface.x;
    for (Vec3& x : moved)
    {
        x.x += way;
    }
    std::vector<Vec3> forces(surface.x.size());
    contact.evaluate(moved, forces);
    contact.evaluate(surface.x, forces);
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < repetitions; ++k)
    {
        contact.evaluate(k % 2 == 0 ? moved : surface.x, forces);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / repetitions;
}

/// What a step takes a rank, a share of the search included.
double step_of(const Surface& surface, int rank, int ranks)
{
    const Pretended others(rank, ranks);
    const auto vertices = std::ssize(surface.x);
    Partition partition;
    for (int k = 0; k <= ranks; ++k)
    {
        partition.first.push_back(vertices * k / ranks);
    }
    std::vector<std::int32_t> particles(surface.x.size());
    std::iota(particles.begin(), particles.end(), 0);
    contact::SurfaceContact contact(surface.triangles, surface.rest, std::vector<double>(surface.x.size(), 0.5), 1.0, 2.5,
                                    {}, {}, contact::no_wall,
                                    contact::SurfaceShare(Share(partition, others), particles));
    const double usual = seconds_of(contact, surface, usual_way);
    const double with_search = seconds_of(contact, surface, 2.0); // farther than any vertex reaches
    return usual + (with_search - usual) / steps_of_a_search;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3)
    {
        fmt::print(stderr, "usage: corticle_contact_shares PARTICLES RANKS...\n");
        return 2;
    }
    fmt::print("{{");
    for (const bool is_folded : {false, true})
    {
        const Surface surface(std::atoll(argv[1]), is_folded);
        fmt::print("{}\"{}\": {{\"vertices\": {}, \"1\": {:.6g}", is_folded ? ", " : "", is_folded ? "folded" : "smooth",
                   surface.x.size(), step_of(surface, 0, 1));
        for (int k = 2; k < argc; ++k)
        {
            const int ranks = std::atoi(argv[k]);
            const int timed = std::min(ranks, most_ranks_timed);
            double slowest = 0.0;
            for (int n = 0; n < timed; ++n)
            {
                slowest = std::max(slowest, step_of(surface, n * ranks / timed, ranks));
            }
            fmt::print(", \"{}\": {:.6g}", ranks, slowest);
        }
        fmt::print("}}");
    }
    fmt::print("}}\n");
    return 0;
}
