// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/ClassController.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <QDate>
#include <QDateTime>
#include <QDir>
#include <QPagedPaintDevice>

#include "app/pages/PageGuard.h"
#include "app/threads/Background.h"
#include "database/AuditHead.h"
#include "lessons/LessonVersion.h"
#include "ui/people/ClassPage.h"
#include "ui/report/Printing.h"
#include "ui/text/Texts.h"

namespace app {
namespace {

namespace text = ui::text;
using database::ClassAssignment;
using database::ClassId;
using database::ClassOverview;
using database::Login;
using database::Repositories;
using database::SchoolClass;
using ui::people::AssignmentChange;
using ui::people::AssignPage;
using ui::people::ClassPage;
using ui::window::MainWindow;

/// Students of the same name get their username behind it; students without a name are called by their username.
ClassOverview withDistinctNames(ClassOverview overview)
{
    std::map<std::string, int> bearers;
    for (const database::MatrixStudent& student : overview.students)
        ++bearers[student.fullName];
    for (database::MatrixStudent& student : overview.students)
        if (student.fullName.empty())
            student.fullName = student.username;
        else if (bearers[student.fullName] > 1)
            student.fullName += " (" + student.username + ")";
    return overview;
}

/// How a class does, and what it was assigned.
struct ClassData
{
    ClassOverview overview;
    QList<ClassAssignment> given;
};

core::Result<ClassData> readClass(const Repositories& school, const Login& who, ClassId ofClass)
{
    auto overview = school.classes.overview(who, ofClass);
    const auto given = school.classes.assignments(who);
    if (!overview || !given)
        return tl::unexpected(overview ? given.error() : overview.error());
    return ClassData{std::move(*overview), QList<ClassAssignment>(given->begin(), given->end())};
}

}  // namespace

ClassController::ClassController(MainWindow& window, UserQueries queries, LessonNames& lessons)
    : m_window(window), m_queries(std::move(queries)), m_lessons(lessons)
{
    connectPages();
    connectReports();
    connect(&m_lessons, &LessonNames::changed, this, &ClassController::showLessons);
}

void ClassController::connectPages()
{
    ClassPage& page = m_window.classPage();
    m_retry.setSingleShot(true);
    m_retry.setInterval(m_queries.school().retryMs());
    connect(&m_retry, &QTimer::timeout, &page, [&page] {
        if (page.isVisible() && !page.isRead())  // a hidden page reads the class when it is opened again
            page.readAgain();
    });
    connect(&page, &ClassPage::listRequested, this, [this] {
        if (!m_queries.who().isGuest())
            readClasses();
    });
    connect(&m_window.navigation(), &ui::window::Navigation::classesRequested, this, &ClassController::open);
    connect(&page, &ClassPage::classChosen, this, [this](qint64 id) { readOverview({id}); });
    connect(&page, &ClassPage::lessonChosen, this, &ClassController::readResults);
    connect(&page, &ClassPage::assignRequested, this, &ClassController::openAssignments);
    connect(&m_window.assignPage(), &AssignPage::changeRequested, this, &ClassController::changeAssignments);
    connect(&page, &ClassPage::studentRequested, this,
            [this](qint64 person) { emit attemptsRequested({person}, nameOf(person), {}); });
    connect(&page, &ClassPage::attemptsRequested, this, [this](qint64 person, const QString& lesson) {
        emit attemptsRequested({person}, nameOf(person), lesson.toStdString());
    });
}

void ClassController::forget()
{
    m_overview = {};
    m_given.clear();
    m_results = {};
}

void ClassController::showLessons()
{
    m_window.classPage().setLessonTitles(m_lessons.titles());
    m_window.assignPage().setLessons(m_lessons.offers());
    if (m_lessons.find(m_results.lessonId) != nullptr)
        showResults();
}

QString ClassController::nameOf(qint64 student) const
{
    for (const database::MatrixStudent& one : m_overview.students)
        if (one.id.value == student)
            return QString::fromStdString(one.fullName);
    return {};
}

void ClassController::open()
{
    m_lessons.read([this, isStillThere = pageStaysOpen(m_window)] {
        readClasses([this, isStillThere] {
            if (!isStillThere())
                return;
            ClassPage& page = m_window.classPage();
            const bool isShown = page.isVisible();  // otherwise the page reads the class when it is shown
            m_window.navigation().openClasses();
            if (isShown)
                page.readAgain();
        });
    });
}

void ClassController::readClasses(const std::function<void()>& then)
{
    m_queries.ask(
        this, [](const Repositories& school, const Login& who) { return school.classes.list(who); },
        [this, then](const core::Result<std::vector<SchoolClass>>& classes) {
            if (!classes) {
                showUnlisted(classes.error());
                return;
            }
            m_window.classPage().setClasses(QList<SchoolClass>(classes->begin(), classes->end()));
            if (then)
                then();
        });
}

/// The classes that were listed before stay in the list.
void ClassController::showUnlisted(const core::Error& error)
{
    ClassPage& page = m_window.classPage();
    if (error.code == core::ErrorCode::NotAllowed || !page.isVisible() || page.isRead()) {
        emit readFailed(error);
        return;
    }
    page.refuse([error] { return text::errorText(error, text::FailedOperation::ReadingSchool); });
    m_retry.start();
}

void ClassController::openAssignments()
{
    m_lessons.read([this, isStillThere = pageStaysOpen(m_window)] {
        m_queries.ask(
            this,
            [ofClass = m_window.classPage().chosenClass()](const Repositories& school, const Login& who) {
                return readClass(school, who, ofClass);
            },
            [this, isStillThere](const core::Result<ClassData>& read) {
                if (!read) {
                    emit readFailed(read.error());
                    return;
                }
                if (!isStillThere())
                    return;
                m_window.assignPage().setAssignments(read->overview, read->given);
                m_window.navigation().openAssign();
            });
    });
}

/// Packs the versions that are assigned now, in the background: a scan takes a while. Then makes the changes.
void ClassController::changeAssignments(const QList<AssignmentChange>& changes)
{
    std::vector<lessons::Lesson> assigned;
    for (const AssignmentChange& change : changes) {
        const bool isNew = change.after && (!change.before || change.before->lessonHash != change.after->lessonHash);
        if (const lessons::Lesson* lesson = isNew ? m_lessons.find(change.after->lessonId) : nullptr)
            assigned.push_back(*lesson);
    }
    inBackground(
        this,
        [assigned]() -> core::Result<Packs> {
            Packs packs;
            for (const lessons::Lesson& lesson : assigned) {
                auto pack = lessons::packVersion(lesson);
                if (!pack)
                    return tl::unexpected(pack.error());
                packs[lesson.hash] = std::move(*pack);
            }
            return packs;
        },
        [this, changes](const core::Result<Packs>& packs) {
            if (packs)
                makeChanges(changes, *packs);
            else
                m_window.assignPage().refuse(text::errorText(packs.error(), text::FailedOperation::ChangingSchool));
        });
}

/// Makes the changes one by one. If one is refused, those before it stay.
void ClassController::makeChanges(const QList<AssignmentChange>& changes, const Packs& packs)
{
    m_queries.ask(
        this,
        [changes, packs](const Repositories& school, const Login& who) -> core::Status {
            for (const AssignmentChange& change : changes) {
                const auto pack = change.after ? packs.find(change.after->lessonHash) : packs.end();
                core::Status done = change.after
                                        ? school.classes.assign(who, *change.after, change.before,
                                                                pack == packs.end() ? QByteArray() : pack->second)
                                        : school.classes.unassign(who, *change.before);
                if (!done)
                    return done;
            }
            return {};
        },
        [this, changes](const core::Status& done) {
            AssignPage& page = m_window.assignPage();
            if (done)
                page.confirm(changes);
            else
                page.refuse(text::errorText(done.error(), text::FailedOperation::ChangingSchool));
            readOverview(page.ofClass());
        });
}

void ClassController::readOverview(ClassId ofClass)
{
    m_queries.ask(
        this, [ofClass](const Repositories& school, const Login& who) { return readClass(school, who, ofClass); },
        [this, ofClass](const core::Result<ClassData>& read) {
            ClassPage& page = m_window.classPage();
            if (!read) {
                showUnread(ofClass, read.error());
                return;
            }
            if (m_window.assignPage().ofClass() == ofClass)
                m_window.assignPage().setAssignments(read->overview, read->given);
            if (page.chosenClass() != ofClass)
                return;
            if (page.isVisible())
                m_window.hideReadError();
            // The results of another class are neither shown nor printed.
            if (m_overview.id != read->overview.id || page.chosenLesson().isEmpty())
                m_results = {};
            m_overview = withDistinctNames(read->overview);
            m_given = read->given;
            page.setOverview(m_overview);
            page.setAssignments(m_given);
            if (!page.chosenLesson().isEmpty())
                readResults(page.chosenLesson());
        });
}

/// A class that is shown stays as it was read before. In the place of any other, the page shows the error.
void ClassController::showUnread(ClassId ofClass, const core::Error& error)
{
    ClassPage& page = m_window.classPage();
    if (error.code == core::ErrorCode::NotAllowed) {  // the user does not teach the class any more
        emit readFailed(error);
        readClasses();
        return;
    }
    if (page.chosenClass() != ofClass || page.isRead()) {
        emit readFailed(error);
        return;
    }
    page.refuse([error] { return text::errorText(error, text::FailedOperation::ReadingSchool); });
    m_retry.start();
}

void ClassController::readResults(const QString& lesson)
{
    const ClassId ofClass = m_window.classPage().chosenClass();
    m_queries.ask(
        this,
        [ofClass, id = lesson.toStdString()](const Repositories& school, const Login& who) {
            return school.classes.results(who, ofClass, id);
        },
        [this, ofClass, lesson](const core::Result<database::LessonResults>& results) {
            const ClassPage& page = m_window.classPage();
            if (!results || page.chosenClass() != ofClass || page.chosenLesson() != lesson)
                return;
            m_results = *results;
            showResults();
        });
}

void ClassController::showResults()
{
    const lessons::Lesson* known = m_lessons.find(m_results.lessonId);
    m_window.classPage().setResults(m_results, known != nullptr ? known->rubric.passMarkTenths : 0,
                                    known != nullptr ? criterionNames(known->rubric) : text::CriterionNames());
}

void ClassController::connectReports()
{
    ClassPage& page = m_window.classPage();
    connect(&page, &ClassPage::pdfRequested, this, &ClassController::savePdf);
    connect(&page, &ClassPage::tableRequested, this, [this, &page](const QString& path) {
        withReport([&page, path, csv = page.csv()](const ui::report::ClassReport&) { page.save(path, csv); });
    });
    connect(&page, &ClassPage::printRequested, this, &ClassController::print);
}

void ClassController::savePdf()
{
    const QString name =
        QString::fromStdString(m_overview.name) + QDate::currentDate().toString(QStringLiteral(", yyyy-MM-dd"));
    ui::report::askForPdf(&m_window, tr("Save the class report"), name, [this](const QString& path) {
        withReport([this, path](const ui::report::ClassReport& report) {
            const bool isSaved = ui::report::savePdf(path, report.className, report);
            m_window.classPage().say([isSaved, path] {
                return isSaved ? tr("The report was saved as %1.").arg(QDir::toNativeSeparators(path))
                               : tr("The report could not be written. Choose another folder, or make room on the "
                                    "disk.");
            });
        });
    });
}

void ClassController::print()
{
    const auto onPaper = [this](const std::shared_ptr<QPagedPaintDevice>& printer) {
        withReport([this, printer](const ui::report::ClassReport& report) {
            const bool isPrinted = ui::report::paintOn(*printer, report);
            m_window.classPage().say([isPrinted] {
                return isPrinted ? tr("The report was printed.") : tr("The printer did not take the report.");
            });
        });
    };
    if (!ui::report::askForPrinter(&m_window, QString::fromStdString(m_overview.name), onPaper))
        m_window.classPage().say([] { return tr("There is no printer on this computer. Save it as a PDF instead."); });
}

/// The report of the class that is shown now: another class may be shown when the audit answers.
ui::report::ClassReport ClassController::report() const
{
    ui::report::ClassReport report;
    report.className = QString::fromStdString(m_overview.name);
    report.teacher = QString::fromStdString(m_queries.who().fullName());
    report.overview = m_overview;
    report.given = m_given;
    report.titles = m_lessons.titles();
    report.results = m_results;
    if (const lessons::Lesson* known = m_lessons.find(m_results.lessonId)) {
        report.passMarkTenths = known->rubric.passMarkTenths;
        report.rubricTitle = known->rubric.title;
        report.rubricVersion = known->rubric.version;
        report.rubricHash = known->rubric.hash;
        report.criteria = criterionNames(known->rubric);
    }
    return report;
}

/// Calls `use` with the report. It names the newest row of the audit, so that paper and database can be compared.
void ClassController::withReport(const std::function<void(const ui::report::ClassReport&)>& use)
{
    if (m_overview.id != m_window.classPage().chosenClass())  // the class is not read yet
        return;
    m_window.classPage().say([] { return tr("The report is being written …"); });
    m_queries.ask(
        this,
        [ofClass = m_overview.id](const Repositories& school, const Login& who) -> core::Result<database::AuditHead> {
            if (const auto noted = school.classes.noteExport(who, ofClass); !noted)
                return tl::unexpected(noted.error());
            return school.audit.head();
        },
        [this, use, report = report()](const core::Result<database::AuditHead>& head) mutable {
            if (!head) {
                m_window.classPage().say(
                    [error = head.error()] { return text::errorText(error, text::FailedOperation::Reporting); });
                return;
            }
            report.proof = {QString::fromStdString(head->code()), QStringLiteral(CUSP_VERSION),
                            QDateTime::currentDateTime()};
            m_window.classPage().repaint();  // shows the message before the work, which takes a while
            use(report);
        });
}

}  // namespace app
