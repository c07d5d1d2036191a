// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PeopleDesk.h"

#include "database/sql/Attempts.h"
#include "database/sql/Classes.h"
#include "database/sql/Overview.h"
#include "lessons/LessonCatalog.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/study/LessonWords.h"

namespace app {
namespace {

using database::sql::School;
using ui::people::ClassPage;
using ui::people::HistoryPage;
using ui::shell::MainWindow;

}  // namespace

PeopleDesk::PeopleDesk(MainWindow& window, SchoolDesk& desk, std::function<database::Session()> who)
    : m_window(window), m_desk(desk), m_who(std::move(who))
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder())) {
        if (!entry.read.lesson)
            continue;
        const lessons::Lesson& lesson = *entry.read.lesson;
        m_titles[QString::fromStdString(lesson.id)] = ui::study::said(lesson.title);
        Known known{lesson.rubric.passMarkTenths, {}};
        for (const lessons::CriterionRule& rule : lesson.rubric.criteria) {
            lessons::Criterion criterion;
            criterion.id = rule.id;
            criterion.title = rule.title;
            criterion.measure = rule.measure;
            known.criteria[rule.id] = ui::text::criterionName(criterion);
        }
        m_lessons[lesson.id] = std::move(known);
    }
    HistoryPage& history = m_window.historyPage();
    history.setLessonTitles(m_titles);
    connect(&m_window, &MainWindow::attemptsWanted, this, [this] { openHistory(m_who().person(), {}, {}); });
    connect(&history, &HistoryPage::lessonChosen, this, &PeopleDesk::tellClassAt);
    connect(&history, &HistoryPage::replayWanted, this, [this](qint64 id) {
        fetch(id, [this](const auto&, const auto& recording) { emit replayWanted(recording); });
    });
    connect(&history, &HistoryPage::attemptOpenWanted, this, [this](qint64 id) {
        fetch(id, [this](const auto& attempt, const auto& recording) { emit scoreWanted(attempt, recording); });
    });
    ClassPage& classes = m_window.classPage();
    classes.setLessonTitles(m_titles);
    connect(&m_window, &MainWindow::classesWanted, this, &PeopleDesk::openClasses);
    connect(&classes, &ClassPage::classChosen, this, [this](qint64 id) { tellOverview({id}); });
    connect(&classes, &ClassPage::lessonChosen, this, &PeopleDesk::tellResults);
    const auto nameOf = [this](qint64 person) {
        for (const database::MatrixStudent& student : m_overview.students)
            if (student.id.value == person)
                return QString::fromStdString(student.fullName);
        return QString();
    };
    connect(&classes, &ClassPage::studentWanted, this,
            [this, nameOf](qint64 person) { openHistory({person}, nameOf(person), {}); });
    connect(&classes, &ClassPage::attemptsWanted, this, [this, nameOf](qint64 person, const QString& lesson) {
        openHistory({person}, nameOf(person), lesson.toStdString());
    });
}

void PeopleDesk::refuse(const core::Error& error)
{
    m_window.showError(error, ui::text::Failed::ReadingSchool);
}

void PeopleDesk::openHistory(database::PersonId person, const QString& fullName,
                             const std::optional<std::string>& lesson)
{
    m_person = person;
    m_desk.ask(
        this, [who = m_who(), person](const School& school) { return database::sql::history(school, who, person, {}); },
        [this, person, fullName, lesson](const core::Result<std::vector<database::AttemptRecord>>& found) {
            if (!found) {
                refuse(found.error());
                return;
            }
            if (person != m_person)
                return;
            HistoryPage& page = m_window.historyPage();
            page.setPerson(fullName);
            page.setHistory(QList<database::AttemptRecord>(found->begin(), found->end()));
            page.setLesson(lesson);
            if (lesson)
                tellClassAt(QString::fromStdString(*lesson));
            m_window.openHistory();
        });
}

/// How the class of the person whose attempts are shown did at a lesson.
void PeopleDesk::tellClassAt(const QString& lesson)
{
    struct Found
    {
        std::vector<database::BandPoint> band;
        std::optional<database::LessonMedians> medians;
    };
    m_desk.ask(
        this,
        [who = m_who(), person = m_person, id = lesson.toStdString()](const School& school) -> core::Result<Found> {
            auto band = database::sql::classBand(school, who, person, id);
            auto medians = database::sql::classMedians(school, who, person, id);
            if (!band || !medians)
                return tl::unexpected(band ? medians.error() : band.error());
            return Found{std::move(*band), *medians};
        },
        [this, id = lesson.toStdString()](const core::Result<Found>& found) {
            HistoryPage& page = m_window.historyPage();
            if (!found || page.lesson() != id)
                return;
            page.setBand(found->band);
            page.setClassMedians(found->medians
                                     ? std::optional(ui::people::ClassMedians{
                                           found->medians->people, found->medians->tenths, found->medians->durationMs})
                                     : std::nullopt);
        });
}

void PeopleDesk::openClasses()
{
    m_desk.ask(
        this, [who = m_who()](const School& school) { return database::sql::listClasses(school, who); },
        [this](const core::Result<std::vector<database::SchoolClass>>& classes) {
            if (!classes) {
                refuse(classes.error());
                return;
            }
            ClassPage& page = m_window.classPage();
            page.setClasses(QList<database::SchoolClass>(classes->begin(), classes->end()));
            if (page.chosenClass().value != 0)
                tellOverview(page.chosenClass());
            m_window.openClasses();
        });
}

void PeopleDesk::tellOverview(database::ClassId ofClass)
{
    m_desk.ask(
        this,
        [who = m_who(), ofClass](const School& school) { return database::sql::classOverview(school, who, ofClass); },
        [this, ofClass](const core::Result<database::ClassOverview>& overview) {
            ClassPage& page = m_window.classPage();
            if (!overview) {
                refuse(overview.error());
                return;
            }
            if (page.chosenClass() != ofClass)
                return;
            m_overview = *overview;
            page.setOverview(*overview);
            if (!page.chosenLesson().isEmpty())
                tellResults(page.chosenLesson());
        });
}

void PeopleDesk::tellResults(const QString& lesson)
{
    const database::ClassId ofClass = m_window.classPage().chosenClass();
    m_desk.ask(
        this,
        [who = m_who(), ofClass, id = lesson.toStdString()](const School& school) {
            return database::sql::lessonResults(school, who, ofClass, id);
        },
        [this, ofClass, lesson](const core::Result<database::LessonResults>& results) {
            ClassPage& page = m_window.classPage();
            if (!results || page.chosenClass() != ofClass || page.chosenLesson() != lesson)
                return;
            const Known& known = m_lessons[lesson.toStdString()];
            page.setResults(*results, known.passMarkTenths, known.criteria);
        });
}

void PeopleDesk::fetch(
    qint64 attempt, const std::function<void(const database::AttemptRecord&, const core::recording::Recording&)>& use)
{
    struct Found
    {
        database::AttemptRecord attempt;
        core::recording::Recording recording;
    };
    m_desk.ask(
        this,
        [who = m_who(), id = database::AttemptId{attempt}](const School& school) -> core::Result<Found> {
            auto record = database::sql::openAttempt(school, who, id);
            if (!record)
                return tl::unexpected(record.error());
            const auto bytes = database::sql::openRecording(school, who, id);
            if (!bytes)
                return tl::unexpected(bytes.error());
            auto recording =
                core::recording::Recording::fromBytes({bytes->constData(), static_cast<std::size_t>(bytes->size())});
            if (!recording)
                return tl::unexpected(recording.error());
            return Found{std::move(*record), std::move(*recording)};
        },
        [this, use](const core::Result<Found>& found) {
            if (found)
                use(found->attempt, found->recording);
            else
                refuse(found.error());
        });
}

}  // namespace app
