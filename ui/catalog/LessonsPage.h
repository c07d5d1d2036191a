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

/// A student's results in one lesson.
struct Standing
{
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;
    QString lastUtc;  ///< of the newest attempt, ISO 8601
};

/// A lesson that is assigned to the student's class.
struct Given
{
    QString className;
    QDateTime due;  ///< invalid: no due date
    /// Empty: no limit.
    std::optional<int> attemptsLeft;
    /// Each class that assigned the lesson, with its due date.
    std::vector<std::pair<QString, QDateTime>> classes = {};
};

/// The home page of a student: all lessons as cards, those due first, with a search, filters and an arch to select a
/// tooth; the description of the selected lesson; and the attempt that can be continued. An invalid lesson is listed
/// with its errors.
class LessonsPage final : public kit::Page
{
    Q_OBJECT
public:
    LessonsPage(const kit::Actions& actions, QWidget* parent);

    /// @param standings, given  by lesson id
    void setLessons(std::vector<::lessons::CatalogEntry> entries, std::map<std::string, Standing> standings,
                    std::map<std::string, Given> given = {});
    /// Offers to continue an unfinished attempt.
    /// @param title  returns the title of its lesson or the name of its tooth; empty: there is no unfinished attempt
    void setUnfinished(const std::function<QString()>& title, const QDateTime& begun);
    /// Shows the unread feedback on the user's attempts.
    /// @param feedback  newest first, read or not
    void setFeedback(const std::vector<database::Feedback>& feedback);
    /// Sets the lesson of the current attempt, which the list marks; empty: none.
    void setPresent(const std::string& lessonId);
    /// Sets whether the user may edit lessons; shows or hides the buttons for that.
    void setMayEdit(bool may);
    /// Sets the lesson files that have unsaved changes in the editor, which the list marks.
    void setUnsaved(const QSet<QString>& files);
    /// Resets the search, the filter and the selection, for another user.
    void forget();
    /// Returns the selected entry, or null.
    [[nodiscard]] const ::lessons::CatalogEntry* chosen() const;
    /// Calls `begin`. For an exam, first emits examAsked() with a question and calls it after the user has accepted.
    void begin(const ::lessons::Lesson& lesson, const std::function<void()>& begin);
    /// Sets the number of attempts left at a lesson until the next setLessons(); empty: no limit.
    void setAttemptsLeft(const std::string& lessonId, std::optional<int> left);
    /// Adds the score of the current lesson. It counts until setLessons() replaces it by the one in the database.
    void takeScore(int tenths, bool passed);
    /// Returns the lesson to do next: the first assigned lesson that is not passed yet, otherwise the next lesson of
    /// the same group in the order of the catalog; null: none.
    [[nodiscard]] const ::lessons::Lesson* next() const;
    /// Starts next(), if there is one.
    void startNext();

signals:
    /// Emitted when an exam would begin, with the question that begins it.
    void examAsked(const kit::ConfirmOverlay::Question& card);
    void lessonChosen(const ::lessons::Lesson& lesson);
    void folderRequested();
    /// Emitted when the user requests to continue the unfinished attempt.
    void resumeRequested();
    void discardRequested();
    /// Emitted when the user requests the feedback on an attempt. 0: there is feedback on several attempts.
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
    void updateContinue();
    void updateMissing();
    void updateFeedback();
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
    std::function<QString()> m_unfinished;  ///< returns its title
    QDateTime m_unfinishedBegun;
    LessonThumbs* m_thumbs;
    std::string m_present;
    bool m_mayEdit = true;
    QSet<QString> m_unsaved;
    QLineEdit* m_search = nullptr;
    QPushButton* m_tooth = nullptr;
    QPushButton* m_folder = nullptr;
    QButtonGroup* m_filter = nullptr;
    QFrame* m_continue = nullptr;
    QLabel* m_continueWords = nullptr;
    QPushButton* m_goOn = nullptr;
    QPushButton* m_discard = nullptr;
    scoring::FeedbackCard* m_feedbackCard = nullptr;
    std::vector<database::Feedback> m_feedback;  ///< unread
    QLabel* m_missing = nullptr;
    QStandardItemModel* m_model = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_goal = nullptr;
    QVBoxLayout* m_factsSlot = nullptr;
    QWidget* m_facts = nullptr;
    LessonPicture* m_picture = nullptr;
    QLabel* m_whyNot = nullptr;  ///< the reason why the lesson cannot be started
    QPushButton* m_start = nullptr;
    QPushButton* m_edit = nullptr;
};

}  // namespace ui::catalog
