// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PeopleDesk.h"

#include <QDir>
#include <QFileDialog>
#include <QStandardPaths>

#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Overview.h"
#include "lessons/LessonCatalog.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/report/Printing.h"
#include "ui/study/LessonWords.h"
#include "ui/study/ScorePage.h"

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
    connectTalk();
    connectReport();
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

void PeopleDesk::connectTalk()
{
    ui::people::TalkPanel& talk = m_window.scorePage().talk();
    connect(&talk, &ui::people::TalkPanel::commentWanted, this,
            [this](const QString& words, std::optional<std::int64_t> momentMs,
                   const std::optional<std::array<double, 3>>& placeMm) {
                sayInTalk([comment = database::sql::NewComment{words.toStdString(), placeMm, momentMs}](
                              const School& school, const database::Session& who, database::AttemptId id) {
                    return database::sql::addComment(school, who, id, comment).map([](std::int64_t) {});
                });
            });
    connect(&talk, &ui::people::TalkPanel::overrideWanted, this,
            [this](std::optional<int> tenths, const QString& reason) {
                sayInTalk([tenths, reason = reason.toStdString()](const School& school, const database::Session& who,
                                                                  database::AttemptId id) {
                    return database::sql::overrideScore(school, who, id, tenths, reason);
                });
            });
    connect(&talk, &ui::people::TalkPanel::momentWanted, &m_window, &MainWindow::momentWanted);
}

/// Does it to the attempt that is talked about, and shows the talk anew; what is refused is said where it was typed.
template <class Work>
void PeopleDesk::sayInTalk(Work work)
{
    if (!m_talkedAbout)
        return;
    m_desk.ask(
        this,
        [who = m_who(), id = database::AttemptId{m_talkedAbout->id},
         work = std::move(work)](const School& school) -> core::Result<bool> {
            if (auto done = work(school, who, id); !done)
                return tl::unexpected(done.error());
            return true;
        },
        [this](const core::Result<bool>& done) {
            if (done)
                tellTalk();
            else
                m_window.scorePage().talk().refuse(ui::text::errorText(done.error(), ui::text::Failed::ReadingSchool));
        });
}

void PeopleDesk::talkAbout(const std::optional<database::AttemptRecord>& attempt)
{
    m_talkedAbout = attempt;
    ui::study::ScorePage& page = m_window.scorePage();
    page.setTalkVisible(attempt.has_value());
    if (!attempt)
        return;
    page.talk().setScore(attempt->scoreTenths, attempt->passMarkTenths, attempt->passed);
    const bool teaches = m_who().role() == database::Role::Instructor && attempt->person != m_who().person();
    page.talk().setMay(teaches, teaches);
    page.talk().setTalk({});
    tellTalk();
}

void PeopleDesk::tellTalk()
{
    m_desk.ask(
        this,
        [who = m_who(), id = database::AttemptId{m_talkedAbout->id}](const School& school) {
            return database::sql::readTalk(school, who, id);
        },
        [this, id = m_talkedAbout->id](const core::Result<database::AttemptTalk>& talk) {
            if (!m_talkedAbout || m_talkedAbout->id != id)
                return;
            if (talk)
                m_window.scorePage().talk().setTalk(*talk);
            else
                refuse(talk.error());
        });
}

void PeopleDesk::connectReport()
{
    ClassPage& classes = m_window.classPage();
    connect(&classes, &ClassPage::pdfWanted, this, [this, &classes] {
        auto* dialog =
            new QFileDialog(&m_window, tr("Save the class report"),
                            QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), tr("PDF (*.pdf)"));
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setAcceptMode(QFileDialog::AcceptSave);
        dialog->setDefaultSuffix(QStringLiteral("pdf"));
        connect(dialog, &QFileDialog::fileSelected, this, [this, &classes](const QString& path) {
            withReport([&classes, path](const ui::report::ClassReport& report) {
                classes.say(ui::report::savePdf(path, report.className, report)
                                ? tr("The report was saved as %1.").arg(QDir::toNativeSeparators(path))
                                : tr("The report could not be written. Choose another folder, or make room on the "
                                     "disk."));
            });
        });
        connect(dialog, &QDialog::finished, &m_window, &QWidget::activateWindow);
        dialog->open();
    });
    connect(&classes, &ClassPage::printWanted, this, [this, &classes] {
        withReport([this, &classes](const ui::report::ClassReport& report) {
            ui::report::print(&m_window, report.className, report, [&classes](bool done) {
                classes.say(done ? tr("The report was printed.") : tr("The printer did not take the report."));
            });
        });
    });
}

/// With the head of the audit as it is now, so that paper and database can be compared.
void PeopleDesk::withReport(const std::function<void(const ui::report::ClassReport&)>& use)
{
    m_desk.ask(
        this, [](const School& school) { return database::sql::auditHead(school); },
        [this, use](const core::Result<database::sql::AuditHead>& head) {
            if (!head) {
                refuse(head.error());
                return;
            }
            ui::report::ClassReport report;
            report.className = QString::fromStdString(m_overview.name);
            report.teacher = QString::fromStdString(m_who().fullName());
            report.overview = m_overview;
            report.titles = m_titles;
            report.results = m_results;
            const Known& known = m_lessons[m_results.lessonId];
            report.passMarkTenths = known.passMarkTenths;
            report.criteria = known.criteria;
            report.proof = {QString::fromStdString(head->code()), QStringLiteral(CUSP_VERSION),
                            QDateTime::currentDateTime()};
            use(report);
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
            m_results = *results;
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
