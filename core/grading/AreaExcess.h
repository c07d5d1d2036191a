// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/grading/Deviation.h"

namespace core::grading {

/// Finds the value that a given area exceeds: a single column is noise, and a mean over the whole floor hides a gouge.
class AreaExcess
{
public:
    /// Adds the value of a column, such as its depth or distance. Values of 0 or less are ignored.
    void add(double value, double areaMm2, std::size_t node)
    {
        if (value > 0.0)
            m_columns.push_back({value, areaMm2, node});
    }
    /// Returns the largest value that columns of this total area reach; 0 if there is less area. The node is that of
    /// the largest value.
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
