// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/observer.hpp"

#include <filesystem>
#include <string>

namespace corticle::record
{

inline constexpr const char* support_table_name = "supports.csv";

/// Writes supports.csv at every output of a run that has supports: one line for each support, with its displacement and
/// the force that it exerts.
class SupportTable final : public model::Observer
{
  public:
    /// @param reached  growth time that the rows of an earlier session count up to; negative: none do
    SupportTable(const std::filesystem::path& folder, double reached);

    void on_output(const model::OutputView& view) override;

  private:
    std::filesystem::path file_;
    std::string text_;
};

} // namespace corticle::record
