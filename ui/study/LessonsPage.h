// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include <QSet>

#include "lessons/LessonCatalog.h"
#include "ui/shell/Page.h"

class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QStandardItemModel;
class QVBoxLayout;

namespace ui::study {

class LessonPicture;

/// What a student has reached in a lesson.
struct Standing
{
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;
};

/// All lessons, in groups, with a search; beside them what the chosen one asks. Faulty ones are listed with what is
/// wrong.
class LessonsPage final : public shell::Page
{
    Q_OBJECT
public:
    LessonsPage(const shell::Actions& actions, QWidget* parent);

    /// @param standings  by lesson's id
    void setLessons(std::vector<::lessons::CatalogEntry> entries, std::map<std::string, Standing> standings);
    /// The lesson on the table, marked in the list; empty for none.
    void setPresent(const std::string& lessonId);
    /// Lessons that began from these files have been changed in the editor and not saved: the list says so.
    void setUnsaved(const QSet<QString>& files);
    /// What is chosen in the list; null for none.
    [[nodiscard]] const ::lessons::CatalogEntry* chosen() const;

signals:
    void lessonChosen(const ::lessons::Lesson& lesson);
    void folderWanted();

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeList();
    QWidget* makeDetails(const shell::Actions& actions);
    void fillList();
    void search();
    void describe();
    void start();

    std::vector<::lessons::CatalogEntry> m_entries;
    std::map<std::string, Standing> m_standings;
    std::string m_present;
    QSet<QString> m_unsaved;
    QLineEdit* m_search = nullptr;
    QStandardItemModel* m_model = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_goal = nullptr;
    QVBoxLayout* m_factsSlot = nullptr;
    QWidget* m_facts = nullptr;
    LessonPicture* m_picture = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_edit = nullptr;
};

}  // namespace ui::study
