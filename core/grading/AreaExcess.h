// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/grading/Deviation.h"

namespace core::grading {

/// Finds what a small area exceeds: one column is noise, and a mean over the whole floor hides a gouge.
class AreaExcess
{
public:
    /// Takes the figure of a column: how deep it is, how far away. Only what is more than 0 counts.
    void add(double value, double areaMm2, std::size_t node)
    {
        if (value > 0.0)
            m_columns.push_back({value, areaMm2, node});
    }
    /// Returns the figure that columns of this area in all have or exceed; 0 where there are not so many. The node is
    /// that of the largest figure.
    [[nodiscard]] Placed over(double areaMm2)
    {
        std::sort(m_columns.begin(), m_columns.end(), [](const Column& a, const Column& b) {
            return a.value != b.value ? a.value > b.value : a.node < b.node;
        });
        double area = 0.0;
        for (const Column& column : m_columns) {
            area += column.areaMm2;
            if (area >= areaMm2)
                return {column.value, m_columns.front().node};
        }
        return {};
    }

private:
    struct Column
    {
        double value = 0.0;
        double areaMm2 = 0.0;
        std::size_t node = 0;
    };
    std::vector<Column> m_columns;
};

}  // namespace core::grading
