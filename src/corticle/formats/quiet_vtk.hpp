// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkObject.h>

namespace corticle::formats
{

/// Keeps VTK from printing from now on; what fails is thrown instead.
inline void silence_vtk()
{
    [[maybe_unused]] static const bool is_silent = []
    {
        vtkObject::SetGlobalWarningDisplay(0);
        return true;
    }();
}

} // namespace corticle::formats
