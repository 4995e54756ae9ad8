// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkObject.h>

namespace corticle
{

/// Keeps VTK from printing; what fails is thrown instead.
class QuietVtk
{
  public:
    QuietVtk() : shown_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::SetGlobalWarningDisplay(0); }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(shown_); }

  private:
    int shown_;
};

} // namespace corticle
