// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::formats
{

/// Of the coordinates of a file.
enum class UnitOfLength
{
    mm,
    cm,
    m
};

/// Factor to millimetres.
constexpr double millimetres_per(UnitOfLength unit)
{
    return unit == UnitOfLength::mm ? 1.0 : unit == UnitOfLength::cm ? 10.0 : 1000.0;
}

} // namespace corticle::formats
