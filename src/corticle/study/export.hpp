// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::study
{

struct ExportRequest
{
    std::filesystem::path run;    ///< run folder
    std::string format = "gifti"; ///< "gifti", "freesurfer", "ply" or "stl"
    std::vector<double> times;    ///< the frames nearest to these are written; empty: the last one
    std::filesystem::path out;    ///< empty: RUN/export
    bool overwrite = false;       ///< replace files of earlier exports of the same names
    std::string structure;        ///< part of the brain, for GIFTI: "CortexLeft", ...; empty: "Cortex"
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
/// surface_t1.000.surf.gii, surface_t1.000.J.shape.gii.
/// @throws InputError for an unknown format, a time that is not finite, a folder that holds no run, or a file that is
/// there already; RunError when a file cannot be written
std::vector<ExportedFrame> export_run(const ExportRequest& request);

} // namespace corticle::study
