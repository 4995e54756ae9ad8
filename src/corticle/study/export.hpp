// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/choices.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::study
{

enum class ExportFormat
{
    gifti,
    freesurfer,
    ply,
    stl
};

struct ExportRequest
{
    std::filesystem::path run; ///< run folder
    ExportFormat format = ExportFormat::gifti;
    std::vector<double> times; ///< the frames nearest to these are written; empty: the last one
    std::filesystem::path out; ///< empty: RUN/export
    bool overwrite = false;    ///< replace files of earlier exports of the same names
    std::string structure;     ///< part of the brain, for GIFTI: "CortexLeft", ...; empty: by the case
    bool split = false;        ///< GIFTI: cut hemispheres that are connected into files of their own
};

/// A frame that was written.
struct ExportedFrame
{
    double t = 0.0;
    std::vector<double> asked;      ///< times it is nearest to; empty when none was asked for
    std::vector<std::string> files; ///< names in the folder
};

/// Writes the deformed surface of a run, in the frame of the input surface [mm], with all scalar arrays of its .vtp:
/// GIFTI and FreeSurfer as one file for each array, PLY as vertex properties, STL without them. Names hold the time:
/// surface_t1.000.surf.gii, surface_t1.000.J.shape.gii. GIFTI comes with a specification file for Connectome Workbench
/// (surface_t1.000.spec), and one surface for each hemisphere (surface_t1.000.L.surf.gii) where nothing connects them,
/// or `split` says so.
/// @throws InputError for a time that is not finite, a folder that holds no run, or a file that is
/// there already; RunError when a file cannot be written
std::vector<ExportedFrame> export_run(const ExportRequest& request);

} // namespace corticle::study

namespace corticle::config
{

template <>
inline std::vector<std::string> names<study::ExportFormat>()
{
    return {"gifti", "freesurfer", "ply", "stl"};
}

} // namespace corticle::config
