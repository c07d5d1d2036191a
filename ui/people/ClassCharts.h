// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QString>

#include "database/ClassOverview.h"
#include "ui/charts/Chart.h"

/// A class at one lesson, as charts. Of fewer than lessons::kFewestPeople people none of them says anything.
namespace ui::people {

/// @param passMarkTenths  0: not known
[[nodiscard]] charts::Chart distributionChart(const database::LessonResults& results, int passMarkTenths);
/// The middle half of the class, attempt by attempt.
[[nodiscard]] charts::Chart learningChart(const database::LessonResults& results, int passMarkTenths);
/// @param names  of the criteria, by id
[[nodiscard]] charts::Chart difficultyChart(const database::LessonResults& results,
                                            const std::map<std::string, QString>& names);
/// "18 of 23 passed, after 2.4 attempts on the average; first attempts came to 58.3"; why not, for too few people.
[[nodiscard]] QString difficultyWords(const database::LessonDifficulty& difficulty);

}  // namespace ui::people
