// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

namespace lessons {

/// Something wrong with a lesson's file.
struct Fault
{
    QString file;
    QString key;        ///< "rubric.criteria[2].weight"; empty: the whole file
    QString what;       ///< one English sentence: what is wrong and what to do
    bool grave = true;  ///< the lesson cannot be given; else it only deserves a look
    [[nodiscard]] QString sentence() const;
};

[[nodiscard]] bool anyGrave(const std::vector<Fault>& faults);

}  // namespace lessons
