// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/run_reader.hpp"
#include "corticle/report/page.hpp"

namespace corticle::report
{

/// A surface at one time, and what is known at its vertices.
struct BodyFrame
{
    double t = 0.0;
    double week = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> points;   ///< [mm]
    std::vector<Vec3> boundary; ///< of cortex and white matter, one point for each vertex [mm]; may be empty
    std::vector<std::pair<std::string, std::vector<double>>> scalars; ///< of the vertices, by key
};

/// A surface over time; its triangles stay.
struct Body
{
    std::string name;
    bool is_brain = false; ///< x to the right, y to the front, z up: sides get their names
    std::vector<Triangle> triangles;
    std::vector<BodyFrame> frames; ///< t ascends
    int step = 1;                  ///< of the numbers that its scalars and its boundary are packed as
};

/// The body of a run folder at the chosen output times, from its surface files and its measures.
Body read_body(const record::RunContents& run, std::span<const std::size_t> chosen, std::string name);

/// All output times.
Body read_body(const record::RunContents& run, std::string name);

/// The arrays into the blobs; what the content says of them, with the ranges of the scalars over all frames.
Json pack_body(const Body& body, Blobs& blobs);

/// The bodies packed so that the arrays take at most so many bytes, if coarser values, then leaving out output times
/// (six remain), and then vertices, help; what was done is said in `notes`.
Json pack_bodies(std::vector<Body> bodies, std::size_t most_bytes, Blobs& blobs, std::vector<std::string>& notes);

} // namespace corticle::report
