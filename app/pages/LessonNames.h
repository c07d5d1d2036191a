// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QObject>

#include "database/Login.h"
#include "lessons/LessonCatalog.h"
#include "ui/people/AssignPage.h"
#include "ui/text/PeopleTexts.h"

namespace app {

/// The names of a rubric's criteria in the user's language, by id.
[[nodiscard]] ui::text::CriterionNames criterionNames(const lessons::Rubric& rubric);

/// The lessons of the catalog, for the pages that show attempts: an attempt stores only the id of its lesson. Ui
/// thread.
class LessonNames final : public QObject
{
    Q_OBJECT

public:
    /// @param who  returns the present login
    explicit LessonNames(std::function<database::Login()> who);

    /// Reads the catalog in the background, as the teachers' folder may have changed, and then calls `then`. Drops the
    /// result if another user has logged in meanwhile.
    void read(const std::function<void()>& then);
    /// Emits changed(): the language has changed.
    void translate();

    /// Null: the lesson does not exist any more.
    [[nodiscard]] const lessons::Lesson* find(const std::string& id) const;
    [[nodiscard]] const ui::text::LessonTitles& titles() const { return m_titles; }
    /// By lesson; practice without a lesson under "".
    [[nodiscard]] std::map<std::string, ui::text::CriterionNames> criteria() const;
    [[nodiscard]] std::vector<ui::people::LessonOffer> offers() const;

signals:
    /// Emitted when the lessons or their titles have changed.
    void changed();

private:
    std::function<database::Login()> m_who;
    std::vector<lessons::CatalogEntry> m_catalog;
    ui::text::LessonTitles m_titles;
};

}  // namespace app
