// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QSet>
#include <QString>
#include <QStringList>

#include "database/AttemptRecord.h"
#include "lessons/LessonCatalog.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/kit/Page.h"

class QButtonGroup;
class QFrame;
class QLabel;
class QLayout;
class QLineEdit;
class QListView;
class QPushButton;
class QStandardItem;
class QStandardItemModel;
class QVBoxLayout;

namespace ui::scoring {
class FeedbackCard;
}

namespace ui::catalog {

class LessonPicture;
class LessonThumbs;

/// What a student has reached in a lesson.
struct Standing
{
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;
    QString lastUtc;  ///< of the newest attempt, ISO 8601
};

/// A lesson that one's class is to do.
struct Given
{
    QString className;
    QDateTime due;  ///< invalid: none
    std::optional<int> attemptsLeft;
    /// Each that gave it, with its day.
    std::vector<std::pair<QString, QDateTime>> classes = {};
};

/// A student's home: all lessons as cards, what is due first, with a search, filters and an arch to pick a tooth by;
/// beside them what the chosen one asks; and what was being worked on last. Faulty ones are there with what is wrong.
class LessonsPage final : public kit::Page
{
    Q_OBJECT
public:
    LessonsPage(const kit::Actions& actions, QWidget* parent);

    /// @param standings, given  by lesson's id
    void setLessons(std::vector<::lessons::CatalogEntry> entries, std::map<std::string, Standing> standings,
                    std::map<std::string, Given> given = {});
    /// An attempt that was not finished can be gone on with.
    /// @param title  of its lesson or tooth; nothing: there is none
    void setUnfinished(const std::function<QString()>& title, const QDateTime& begun);
    /// What teachers have said of one's attempts, newest first; what was read already is not told.
    void setFeedback(const std::vector<database::Feedback>& feedback);
    /// The lesson on the table, marked in the list; empty for none.
    void setPresent(const std::string& lessonId);
    /// Who is here changes lessons: there is a way to the editor.
    void setMayEdit(bool may);
    /// Lessons that began from these files have been changed in the editor and not saved: the list says so.
    void setUnsaved(const QSet<QString>& files);
    /// Somebody else comes: what was searched for, filtered and chosen is not his.
    void forget();
    /// What is chosen in the list; null for none.
    [[nodiscard]] const ::lessons::CatalogEntry* chosen() const;
    /// Begins a lesson. An exam waits until the user has accepted its card, which examAsked() brings.
    void begin(const ::lessons::Lesson& lesson, const std::function<void()>& begin);
    /// How many attempts at a lesson are left; no value: no limit. Until setLessons() brings the same.
    void setAttemptsLeft(const std::string& lessonId, std::optional<int> left);
    /// The present lesson was graded. Counts until setLessons() brings the same from the database.
    void takeScore(int tenths, bool passed);
    /// The lesson to do after the present one: the first assigned lesson that is not passed yet, or else the next
    /// lesson of the same group in the order of the catalog; null for none.
    [[nodiscard]] const ::lessons::Lesson* next() const;
    /// Chooses next(), if there is one.
    void startNext();

signals:
    /// Emitted when an exam is to begin, with the card that begins it.
    void examAsked(const kit::ConfirmOverlay::Question& card);
    void lessonChosen(const ::lessons::Lesson& lesson);
    void folderRequested();
    /// The attempt that was not finished is to be gone on with.
    void resumeRequested();
    void discardRequested();
    /// What was said of this attempt is to be read; 0: there are several.
    void feedbackRequested(qint64 attempt);

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Filter { All, ToDo, Passed, Exams };

    QWidget* makeList();
    QLayout* makeSearch(QWidget* side);
    void makeCards(QWidget* side);
    QWidget* makeFilters(QWidget* parent);
    QWidget* makeContinue(QWidget* parent);
    void pickTooth();
    [[nodiscard]] bool isToDo(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] bool isWanted(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] const Standing* standingOf(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] const Given* givenOf(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] bool isUsedUp(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] QString searchedWords(const ::lessons::CatalogEntry& entry) const;
    [[nodiscard]] std::vector<std::size_t> found() const;
    void fillCard(QStandardItem& item, const ::lessons::CatalogEntry& entry) const;
    void tellContinue();
    void tellMissing();
    void tellFeedback();
    void goOn();
    [[nodiscard]] const ::lessons::CatalogEntry* lastTried() const;
    QWidget* makeDetails(const kit::Actions& actions);
    void fillList();
    void search();
    void describe();
    struct Fact
    {
        QString name;
        QString value;
    };
    [[nodiscard]] static QString assignedWords(const Given& given, const Standing* done);
    [[nodiscard]] QList<Fact> factsOf(const ::lessons::CatalogEntry& entry) const;
    void turnPage(bool down);
    void start();
    void choose(const ::lessons::Lesson& lesson);
    [[nodiscard]] QString attemptsWords(const std::string& lessonId) const;

    std::vector<::lessons::CatalogEntry> m_entries;
    std::map<std::string, Standing> m_standings;
    std::map<std::string, Given> m_given;
    std::function<QString()> m_unfinished;  ///< its title
    QDateTime m_unfinishedBegun;
    LessonThumbs* m_thumbs;
    std::string m_present;
    bool m_mayEdit = true;
    QSet<QString> m_unsaved;
    QLineEdit* m_search = nullptr;
    QPushButton* m_tooth = nullptr;
    QButtonGroup* m_filter = nullptr;
    QFrame* m_continue = nullptr;
    QLabel* m_continueWords = nullptr;
    QPushButton* m_goOn = nullptr;
    QPushButton* m_discard = nullptr;
    scoring::FeedbackCard* m_feedbackCard = nullptr;
    std::vector<database::Feedback> m_feedback;  ///< new
    QLabel* m_missing = nullptr;
    QStandardItemModel* m_model = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_goal = nullptr;
    QVBoxLayout* m_factsSlot = nullptr;
    QWidget* m_facts = nullptr;
    LessonPicture* m_picture = nullptr;
    QLabel* m_whyNot = nullptr;  ///< it cannot be started
    QPushButton* m_start = nullptr;
    QPushButton* m_edit = nullptr;
};

}  // namespace ui::catalog
